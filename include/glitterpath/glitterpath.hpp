// Glitterpath for C++20: the C interface with owners instead of handles and exceptions instead of
// codes. Header only, the same nouns; whatever is not here is called as in C, with get().
//
//     gp::Device device;
//     gp::Scene scene(device);
//     scene.load("helmet.glb");
//     gp::Frame frame(device, 640, 360);
//     frame.render(scene);
//     frame.save("helmet.png");
//
// Objects are moved, not copied; each gives its handle back when it ends. A moved-from or
// default-constructed object is empty. Threads and units: see glitterpath.h.
#ifndef GLITTERPATH_HPP
#define GLITTERPATH_HPP

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "glitterpath/glitterpath.h"

namespace gp {
inline namespace wrapper {  // so that these names never meet those inside of the library

// What failing calls throw: the code, and the library's one line as what().
class Error : public std::runtime_error {
public:
    Error(GpError code, const char* message) : std::runtime_error(message), code_(code) {}
    GpError code() const noexcept { return code_; }

private:
    GpError code_;
};

namespace detail {

// The reason of a failure stands with the device, or with none where there was none.
[[noreturn]] inline void raise(GpDevice device) {
    const char* message = "";
    GpError code = gpGetError(device, &message);
    if (code == GP_SUCCESS) code = gpGetError(nullptr, &message);
    throw Error(code, message);
}

inline void check(GpError result, GpDevice device) {
    if (result != GP_SUCCESS) raise(device);
}

template <class Handle>
Handle checked(Handle handle, GpDevice device) {
    if (!handle) raise(device);
    return handle;
}

}  // namespace detail

// Owns one handle; `release` gives it back.
template <class Handle, GpError (*release)(Handle)>
class Owner {
public:
    Owner() = default;
    Owner(Handle handle, GpDevice device) : handle_(handle), device_(device) {}
    Owner(Owner&& other) noexcept { swap(other); }
    Owner& operator=(Owner&& other) noexcept {
        Owner(std::move(other)).swap(*this);
        return *this;
    }
    ~Owner() {
        if (handle_) release(handle_);
    }

    Handle get() const noexcept { return handle_; }
    GpDevice device() const noexcept { return device_; }
    explicit operator bool() const noexcept { return handle_ != nullptr; }

protected:
    void check(GpError result) const { detail::check(result, device_); }
    void forget() noexcept { handle_ = nullptr; }  // the library has taken the handle back

private:
    void swap(Owner& other) noexcept {
        std::swap(handle_, other.handle_);
        std::swap(device_, other.device_);
    }
    Handle handle_ = nullptr;
    GpDevice device_ = nullptr;
};

// Outlives everything made from it.
class Device : public Owner<GpDevice, gpReleaseDevice> {
public:
    explicit Device(const GpDeviceDesc& desc = {}) : Device(gpNewDevice(&desc)) {}
    std::string name() const { return detail::checked(gpGetDeviceName(get()), get()); }
    void cancel() const noexcept { gpCancelRender(get()); }
    void setTextureOverrides(const GpTextureOverrides& overrides) {
        check(gpSetTextureOverrides(get(), &overrides));
    }
    void clearTextureOverrides() { check(gpSetTextureOverrides(get(), nullptr)); }

private:
    explicit Device(GpDevice handle) : Owner(detail::checked(handle, nullptr), handle) {}
};

class Texture : public Owner<GpTexture, gpReleaseTexture> {
public:
    Texture() = default;
    Texture(const Device& d, const GpTextureDesc& desc)
        : Owner(detail::checked(gpNewTexture(d.get(), &desc), d.get()), d.get()) {}
    Texture(const Device& d, const std::string& path, const GpTextureDesc& desc = {})
        : Owner(detail::checked(gpNewTextureFromFile(d.get(), path.c_str(), &desc), d.get()),
                d.get()) {}
    void update(const GpTextureUpdate& update) { check(gpUpdateTexture(get(), &update)); }
};

class Material : public Owner<GpMaterial, gpReleaseMaterial> {
public:
    Material() = default;
    explicit Material(const Device& d, const GpMaterialDesc& desc = {})
        : Owner(detail::checked(gpNewMaterial(d.get(), &desc), d.get()), d.get()) {}
    // An animated one, which shows one of `frames`.
    static Material animated(const Device& d, const std::vector<GpMaterial>& frames) {
        Material material;
        static_cast<Owner&>(material) = Owner(
            detail::checked(gpNewAnimatedMaterial(d.get(), frames.data(), uint32_t(frames.size())),
                            d.get()),
            d.get());
        return material;
    }
    void setFrame(uint32_t frame) { check(gpSetMaterialFrame(get(), frame)); }
};

class Mesh : public Owner<GpMesh, gpReleaseMesh> {
public:
    Mesh() = default;
    Mesh(const Device& d, const GpMeshDesc& desc)
        : Owner(detail::checked(gpNewMesh(d.get(), &desc), d.get()), d.get()) {}
    void update(const GpMeshDesc& desc) { check(gpUpdateMesh(get(), &desc)); }
    void updateTexCoords(uint32_t set, const float* uv, size_t stride = 0) {
        check(gpUpdateTexCoords(get(), set, uv, stride));
    }
};

class Scene : public Owner<GpScene, gpReleaseScene> {
public:
    Scene() = default;
    explicit Scene(const Device& d)
        : Owner(detail::checked(gpNewScene(d.get()), d.get()), d.get()) {}
    void load(const std::string& path, const GpLoadOptions& options = {}) {
        check(gpLoadSceneFile(get(), path.c_str(), &options));
    }
    void setTime(double time, const GpPlayOptions& options = {}) {
        check(gpSetSceneTime(get(), time, &options));
    }
    void setEnvironment(const GpEnvironmentDesc& desc) { check(gpSetEnvironment(get(), &desc)); }
    void setEnvironment(const std::string& path, const GpEnvironmentDesc& desc = {}) {
        check(gpSetEnvironmentFromFile(get(), path.c_str(), &desc));
    }
    void setCubemap(const GpCubemapDesc& desc) { check(gpSetCubemap(get(), &desc)); }
    void setSky(float sunAzimuth, float sunElevation, float sunLux = 0) {
        check(gpSetSky(get(), sunAzimuth, sunElevation, sunLux));
    }
    // NULL: every material. How many instances have another one now, and what maps they kept.
    uint32_t replaceMaterial(const char* name, const Material& material) {
        uint32_t replaced = 0;
        check(gpReplaceMaterial(get(), name, material.get(), &replaced));
        return replaced;
    }
    GpReplacedMaterials replaceMaterialModel(const char* name, const Material& material,
                                             uint32_t keep = GP_MAP_ALL) {
        GpReplacedMaterials replaced{};
        check(gpReplaceMaterialModel(get(), name, material.get(), keep, &replaced));
        return replaced;
    }
    void setOcean(const GpOceanDesc& desc = {}) { check(gpSetOcean(get(), &desc)); }
    void removeOcean() { check(gpSetOcean(get(), nullptr)); }
    void setOceanTime(double seconds) { check(gpSetOceanTime(get(), seconds)); }
    GpOceanSample sampleOcean(float x, float z) const {
        const float point[2] = {x, z};
        GpOceanSample result{};
        check(gpSampleOcean(get(), 1, point, &result));
        return result;
    }
    void saveOceanMaps(const std::string& folder) const {
        check(gpSaveOceanMaps(get(), folder.c_str()));
    }
    GpSceneInfo info() const {
        GpSceneInfo result{};
        check(gpGetSceneInfo(get(), &result));
        return result;
    }
    std::string describe() const {
        size_t needed = 0;
        check(gpDescribeScene(get(), nullptr, 0, &needed));
        std::string text(needed, '\0');
        check(gpDescribeScene(get(), text.data(), text.size(), nullptr));
        text.pop_back();  // the closing zero
        return text;
    }
    GpCameraDesc camera(uint32_t index) const {
        GpCameraDesc result{};
        check(gpGetSceneCamera(get(), index, &result, nullptr));
        return result;
    }
    GpLightDesc light(uint32_t index) const {  // its pointers live until the light is changed
        GpLightDesc result{};
        check(gpGetSceneLight(get(), index, &result, nullptr));
        return result;
    }
    GpCameraDesc frame(float aspect) const {
        GpCameraDesc result{};
        check(gpFrameScene(get(), aspect, &result));
        return result;
    }
};

// Letting go of an instance or a light leaves it in its scene; remove() takes it out.
class Instance : public Owner<GpInstance, gpReleaseInstance> {
public:
    Instance() = default;
    Instance(const Scene& s, const GpInstanceDesc& desc)
        : Owner(detail::checked(gpNewInstance(s.get(), &desc), s.device()), s.device()) {}
    void setTransform(const float* worldFromObject) {
        check(gpSetInstanceTransform(get(), worldFromObject));
    }
    void setMaterial(const Material& material) {
        check(gpSetInstanceMaterial(get(), material.get()));
    }
    void setColor(const float* rgba) { check(gpSetInstanceColor(get(), rgba)); }
    void setVisibility(GpVisibility visibility, uint32_t invisibleTo = 0) {
        check(gpSetInstanceVisibility(get(), visibility, invisibleTo));
    }
    void remove() {
        check(gpRemoveInstance(get()));
        forget();
    }
};

class Light : public Owner<GpLight, gpReleaseLight> {
public:
    Light() = default;
    Light(const Scene& s, const GpLightDesc& desc)
        : Owner(detail::checked(gpNewLight(s.get(), &desc), s.device()), s.device()) {}
    // One that is there already, by its number in Scene::light().
    Light(const Scene& s, uint32_t index) : Owner(handleOf(s, index), s.device()) {}
    void set(const GpLightDesc& desc) { check(gpSetLight(get(), &desc)); }
    void remove() {
        check(gpRemoveLight(get()));
        forget();
    }

private:
    static GpLight handleOf(const Scene& s, uint32_t index) {
        GpLightDesc desc{};
        GpLight light = nullptr;
        detail::check(gpGetSceneLight(s.get(), index, &desc, &light), s.device());
        return light;
    }
};

class Frame : public Owner<GpFrame, gpReleaseFrame> {
public:
    Frame() = default;
    Frame(const Device& d, uint32_t width, uint32_t height, GpFrameMode mode = GP_MODE_REFERENCE)
        : Frame(d, descOf(width, height, mode)) {}
    Frame(const Device& d, const GpFrameDesc& desc)
        : Owner(detail::checked(gpNewFrame(d.get(), &desc), d.get()), d.get()),
          pixels_(size_t(desc.width) * desc.height) {}
    void render(const Scene& scene, const GpRenderOptions& options = {}) {
        check(gpRender(get(), scene.get(), nullptr, &options));
    }
    void render(const Scene& scene, const GpCameraDesc& camera,
                const GpRenderOptions& options = {}) {
        check(gpRender(get(), scene.get(), &camera, &options));
    }
    void draw(const GpDrawDesc& desc) { check(gpDraw(get(), &desc)); }  // by the next render()
    void tonemap(float exposureEv, GpTonemap curve = GP_TONEMAP_AGX) {
        check(gpTonemapFrame(get(), exposureEv, curve));
    }
    std::vector<std::byte> read(GpFrameImage image) const {
        GpImageInfo info{};
        detail::check(gpGetImageInfo(image, &info), nullptr);
        std::vector<std::byte> bytes(pixels_ * info.bytesPerPixel);
        check(gpReadFrameImage(get(), image, bytes.data(), bytes.size()));
        return bytes;
    }
    void save(const std::string& path, const GpSaveOptions& options = {}) const {
        check(gpSaveFrame(get(), path.c_str(), &options));
    }
    // Of GP_MODE_REALTIME, as gpGetPassTimes and gpReadFrameLayer; four floats a pixel.
    std::vector<GpPassTime> passTimes() const {
        uint32_t count = 0;
        check(gpGetPassTimes(get(), nullptr, 0, &count));
        std::vector<GpPassTime> times(count);
        check(gpGetPassTimes(get(), times.data(), count, &count));
        return times;
    }
    std::vector<float> layer(const std::string& name) const {
        std::vector<float> pixels(pixels_ * 4);
        check(gpReadFrameLayer(get(), name.c_str(), pixels.data(), pixels.size() * sizeof(float)));
        return pixels;
    }
    GpFrameStatistics statistics() const {
        GpFrameStatistics result{};
        check(gpGetFrameStatistics(get(), &result));
        return result;
    }

private:
    static GpFrameDesc descOf(uint32_t width, uint32_t height, GpFrameMode mode) {
        GpFrameDesc desc{};
        desc.mode = mode;
        desc.width = width;
        desc.height = height;
        return desc;
    }
    size_t pixels_ = 0;
};

// Vertices one by one; what mesh() and draw() fill in holds until the next call of another.
class Immediate : public Owner<GpImmediate, gpReleaseImmediate> {
public:
    Immediate() = default;
    explicit Immediate(const Device& d)
        : Owner(detail::checked(gpNewImmediate(d.get()), d.get()), d.get()) {}
    void begin(GpPrimitive primitive) { check(gpBegin(get(), primitive)); }
    void end() { check(gpEnd(get())); }
    void clear() { check(gpClearImmediate(get())); }
    void shadeModel(GpShadeModel model) { check(gpShadeModel(get(), model)); }
    void color(float r, float g, float b, float a = 1) { check(gpColor4f(get(), r, g, b, a)); }
    void normal(float x, float y, float z) { check(gpNormal3f(get(), x, y, z)); }
    void texCoord(float u, float v) { check(gpTexCoord2f(get(), u, v)); }
    void vertex(float x, float y, float z = 0) { check(gpVertex3f(get(), x, y, z)); }
    void mesh(GpMeshDesc& desc) const { check(gpGetImmediateMesh(get(), &desc)); }
    void draw(GpDrawDesc& desc) const { check(gpGetImmediateDraw(get(), &desc)); }
};

// A reflectance model on its own; arrays as for gpEvaluateBsdf and gpSampleBsdf.
class Bsdf : public Owner<GpBsdf, gpReleaseBsdf> {
public:
    Bsdf() = default;
    Bsdf(const Device& d, const GpBsdfDesc& desc)
        : Owner(detail::checked(gpNewBsdf(d.get(), &desc), d.get()), d.get()) {}
    Bsdf(const Device& d, const std::string& model,
         const std::vector<GpBsdfParameter>& parameters = {})
        : Bsdf(d, descOf(model, parameters)) {}
    void evaluate(size_t count, const float* wi, const float* wo, GpBsdfValue* values) const {
        check(gpEvaluateBsdf(get(), count, wi, wo, values));
    }
    void sample(size_t count, const float* wo, const float* u, GpBsdfSample* samples) const {
        check(gpSampleBsdf(get(), count, wo, u, samples));
    }

private:
    static GpBsdfDesc descOf(const std::string& model,
                             const std::vector<GpBsdfParameter>& parameters) {
        GpBsdfDesc desc{};
        desc.model = model.c_str();
        desc.parameters = parameters.data();
        desc.parameterCount = uint32_t(parameters.size());
        return desc;
    }
};

}  // namespace wrapper
}  // namespace gp
#endif
