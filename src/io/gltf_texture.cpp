// The images and samplers behind the textures that materials asked for.
#include <exception>

#include <tbb/parallel_for.h>

#include "io/gltf_material.h"
#include "io/image_file.h"

namespace gp::io {

namespace {

// sampler.wrapS, wrapT; magFilter and minFilter (glTF 2.0, 5.26: the numbers of OpenGL)
Wrap wrapOf(const Value& sampler, const char* key) {
    switch (sampler.count(key, 10497)) {
        case 10497: return Wrap::repeat;
        case 33071: return Wrap::clampToEdge;
        case 33648: return Wrap::mirroredRepeat;
        default: sampler.fail(std::string("unknown ") + key);
    }
}

// Where the bytes of an image are; owned where they do not lie in a buffer.
struct ImageBytes {
    std::vector<std::byte> owned;
    std::span<const std::byte> bytes;
};

ImageBytes imageBytes(Document& document, const Value& image) {
    ImageBytes b;
    if (const auto view = image.index("bufferView", "bufferViews")) {
        b.bytes = document.view(*view).bytes;
        return b;
    }
    b.owned = document.readUri(image["uri"]);
    b.bytes = b.owned;  // moving the vector keeps its memory
    return b;
}

}  // namespace

TextureDesc Materials::describe(const Key& key) const {
    const auto [image, sampler, space] = key;
    TextureDesc d;
    const Value value = m_document.element("images", image);
    d.name = value.text("name", "image " + std::to_string(image));
    d.colorSpace = space;
    if (sampler < 0) return d;
    const Value s = m_document.element("samplers", static_cast<uint32_t>(sampler));
    d.wrapU = wrapOf(s, "wrapS");
    d.wrapV = wrapOf(s, "wrapT");
    const uint64_t mag = s.count("magFilter", 9729), min = s.count("minFilter", 9987);
    if ((mag != 9728 && mag != 9729) || (min != 9728 && min != 9729 && (min < 9984 || min > 9987)))
        s.fail("unknown filter");
    d.magFilter = mag == 9728 ? Filter::nearest : Filter::linear;
    // 9728 NEAREST, 9984 and 9986 NEAREST_MIPMAP_*; 9729, 9985 and 9987 are their LINEAR kin
    d.minFilter = min % 2 == 0 ? Filter::nearest : Filter::linear;
    d.mipmapped = min >= 9984;
    return d;
}

void Materials::decodeImages(const std::vector<uint32_t>& images, std::vector<Image>& decoded) {
    std::vector<ImageBytes> files;
    for (const uint32_t i : images)
        files.push_back(imageBytes(m_document, m_document.element("images", i)));
    // The first error in the file's order, whatever the threads do.
    std::vector<std::exception_ptr> errors(images.size());
    tbb::parallel_for(size_t(0), images.size(), [&](size_t i) {
        const std::string label =
            m_document.path() + ": " + m_document.element("images", images[i]).where();
        try {
            decoded[images[i]] = decodeImage(files[i].bytes, label, m_maxPixels);
            m_document.budget().spend(decoded[images[i]].pixels.size(),
                                      m_document.element("images", images[i]));
        } catch (...) {
            errors[i] = std::current_exception();
        }
        files[i] = {};
    });
    for (const std::exception_ptr& e : errors)
        if (e) std::rethrow_exception(e);
}

void Materials::loadTextures() {
    std::vector<uint32_t> images;
    for (const auto& [key, users] : m_wanted)
        if (images.empty() || images.back() != std::get<0>(key)) images.push_back(std::get<0>(key));
    std::vector<Image> decoded(m_document.size("images"));
    decodeImages(images, decoded);

    struct Job {
        TextureDesc desc;
        bool last;  // of those that share the image: takes its pixels
        const std::vector<TextureUse*>* users;
        uint32_t image;
    };
    std::vector<Job> jobs;
    for (auto it = m_wanted.begin(); it != m_wanted.end(); ++it) {
        const uint32_t image = std::get<0>(it->first);
        const auto next = std::next(it);
        const bool last = next == m_wanted.end() || std::get<0>(next->first) != image;
        jobs.push_back({describe(it->first), last, &it->second, image});
        if (!last)
            m_document.budget().spend(decoded[image].pixels.size(),
                                      m_document.element("images", image));
    }
    for (Job& job : jobs)
        job.desc.image = job.last ? std::move(decoded[job.image]) : decoded[job.image];
    tbb::parallel_for(size_t(0), jobs.size(), [&](size_t i) {
        const std::shared_ptr<const Texture> texture = makeTexture(std::move(jobs[i].desc));
        for (TextureUse* user : *jobs[i].users) user->texture = texture;
    });
    checkSlopeMaps();
}

}  // namespace gp::io
