// Scenes, their files, instances and cameras.
#include <fstream>
#include <limits>

#include "api/world.h"

namespace gp::test {

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float inf = std::numeric_limits<float>::infinity();

Row instanceRow(const char* what, GpError expected, const char* message,
                void (*change)(World&, GpInstanceDesc&)) {
    return {"gpNewInstance", what, expected, message, [change](World& w) {
                GpInstanceDesc desc{};
                desc.mesh = w.mesh;
                change(w, desc);
                return made(gpNewInstance(w.scene, &desc));
            }};
}

Row transformRow(const char* what, GpError expected, const char* message, size_t index,
                 float value) {
    return {"gpSetInstanceTransform", what, expected, message, [index, value](World& w) {
                float rows[12];
                for (size_t i = 0; i < 12; ++i) rows[i] = identity[i];
                rows[index] = value;
                return gpSetInstanceTransform(w.instance, rows);
            }};
}

Row loadRow(const char* what, GpError expected, const char* message, const char* name,
            const char* content) {
    return {"gpLoadSceneFile", what, expected, message, [name, content](World& w) {
                const std::string path = w.folder + name;
                std::ofstream(path) << content;
                return gpLoadSceneFile(w.scene, path.c_str(), nullptr);
            }};
}

Rows instanceHandleRows() {
    Rows rows;
    addHandleRows<GpScene>(rows, "gpNewInstance", "scene", [](World& w, GpScene s) {
        GpInstanceDesc desc{};
        desc.mesh = w.mesh;
        return made(gpNewInstance(s, &desc));
    });
    addHandleRows<GpMesh>(rows, "gpNewInstance", "mesh", [](World& w, GpMesh m) {
        GpInstanceDesc desc{};
        desc.mesh = m;
        return made(gpNewInstance(w.scene, &desc));
    });
    addHandleRows<GpInstance>(
        rows, "gpSetInstanceTransform", "instance",
        [](World&, GpInstance i) { return gpSetInstanceTransform(i, identity); });
    addHandleRows<GpInstance>(rows, "gpRemoveInstance", "instance",
                              [](World&, GpInstance i) { return gpRemoveInstance(i); });
    addHandleRows<GpInstance>(rows, "gpReleaseInstance", "instance",
                              [](World&, GpInstance i) { return gpReleaseInstance(i); });
    return rows;
}

}  // namespace

Rows instanceRows() {
    Rows rows = {
        {"gpNewInstance", "no descriptor", GP_ERROR_INVALID_ARGUMENT, "desc is NULL",
         [](World& w) { return made(gpNewInstance(w.scene, nullptr)); }},
        {"gpNewInstance", "a descriptor of zeros", GP_ERROR_INVALID_HANDLE, "mesh is NULL",
         [](World& w) {
             const GpInstanceDesc zeros{};
             return made(gpNewInstance(w.scene, &zeros));
         }},
        instanceRow("mesh of another device", GP_ERROR_INVALID_HANDLE,
                    "mesh belongs to another device",
                    [](World& w, GpInstanceDesc& d) { d.mesh = w.foreign.mesh; }),
        instanceRow("material was released", GP_ERROR_INVALID_HANDLE, "material was released",
                    [](World& w, GpInstanceDesc& d) { d.material = w.released.material; }),
        instanceRow("an id twice", GP_ERROR_DUPLICATE_ID, "id 7",
                    [](World&, GpInstanceDesc& d) { d.id = 7; }),
        instanceRow("unknown visibility", GP_ERROR_INVALID_ARGUMENT, "invisibleTo",
                    [](World&, GpInstanceDesc& d) { d.invisibleTo = 8; }),
        instanceRow("sky that some rays do not see", GP_ERROR_INVALID_ARGUMENT,
                    "invisibleTo is 0x2, but all rays see",
                    [](World&, GpInstanceDesc& d) {
                        d.visibility = GP_VISIBILITY_SKY, d.invisibleTo = GP_VISIBLE_BOUNCE;
                    }),
        instanceRow("a transform that is NaN", GP_ERROR_NOT_FINITE, "worldFromObject[3] is nan",
                    [](World&, GpInstanceDesc& d) { d.worldFromObject[3] = nan; }),
        instanceRow("a transform that only moves", GP_ERROR_OUT_OF_RANGE, "cannot be inverted",
                    [](World&, GpInstanceDesc& d) { d.worldFromObject[3] = 5; }),
        {"gpSetInstanceTransform", "no transform", GP_ERROR_INVALID_ARGUMENT,
         "worldFromObject is NULL",
         [](World& w) { return gpSetInstanceTransform(w.instance, nullptr); }},
        {"gpSetInstanceTransform", "twelve zeros", GP_ERROR_OUT_OF_RANGE, "cannot be inverted",
         [](World& w) {
             const float zeros[12] = {};
             return gpSetInstanceTransform(w.instance, zeros);
         }},
        {"gpSetInstanceTransform", "a static mesh", GP_ERROR_INVALID_OPERATION, "GP_MESH_STATIC",
         [](World& w) { return gpSetInstanceTransform(w.staticInstance, identity); }},
        transformRow("one axis is zero", GP_ERROR_OUT_OF_RANGE, "cannot be inverted", 5, 0),
        transformRow("one axis is too short to invert", GP_ERROR_OUT_OF_RANGE, "inverse", 0,
                     1e-44f),
        transformRow("infinite translation", GP_ERROR_NOT_FINITE, "worldFromObject[11] is inf", 11,
                     inf),
        {"gpRemoveInstance", "twice", GP_ERROR_INVALID_HANDLE, "was released",
         [](World& w) {
             GpInstanceDesc desc{};
             desc.mesh = w.mesh;
             const GpInstance extra = gpNewInstance(w.scene, &desc);
             gpRemoveInstance(extra);
             return gpRemoveInstance(extra);
         }},
    };
    const Rows more = instanceHandleRows();
    rows.insert(rows.end(), more.begin(), more.end());
    return rows;
}

Rows sceneRows() {
    Rows rows = {
        {"gpLoadSceneFile", "no path", GP_ERROR_INVALID_ARGUMENT, "path is NULL",
         [](World& w) { return gpLoadSceneFile(w.scene, nullptr, nullptr); }},
        {"gpLoadSceneFile", "empty path", GP_ERROR_INVALID_ARGUMENT, "path is empty",
         [](World& w) { return gpLoadSceneFile(w.scene, "", nullptr); }},
        {"gpLoadSceneFile", "no such file", GP_ERROR_FILE_NOT_FOUND, "nowhere.glb",
         [](World& w) { return gpLoadSceneFile(w.scene, "nowhere.glb", nullptr); }},
        loadRow("no JSON", GP_ERROR_FILE_INVALID, "gp_misuse_1.gltf", "gp_misuse_1.gltf", "{ no"),
        loadRow("no GLB", GP_ERROR_FILE_INVALID, "gp_misuse_2.glb", "gp_misuse_2.glb", "glTF"),
        loadRow("a required extension that nobody has", GP_ERROR_UNSUPPORTED, "ACME_teleport",
                "gp_misuse_3.gltf",
                R"({"asset":{"version":"2.0"},"extensionsUsed":["ACME_teleport"],)"
                R"("extensionsRequired":["ACME_teleport"]})"),
        {"gpLoadSceneFile", "a time that is NaN", GP_ERROR_NOT_FINITE, "options.time is nan",
         [](World& w) {
             GpLoadOptions options{};
             options.time = double(nan);
             return gpLoadSceneFile(w.scene, "nowhere.glb", &options);
         }},
        {"gpLoadSceneFile", "animation number too large", GP_ERROR_OUT_OF_RANGE, "animation",
         [](World& w) {
             GpLoadOptions options{};
             options.animation = 4000000000u;
             return gpLoadSceneFile(w.scene, "nowhere.glb", &options);
         }},
        {"gpLoadSceneFile", "scene number too large", GP_ERROR_OUT_OF_RANGE, "options.scene",
         [](World& w) {
             GpLoadOptions options{};
             options.scene = 4000000000u;
             return gpLoadSceneFile(w.scene, "nowhere.glb", &options);
         }},
        {"gpSetSceneTime", "a time that is infinite", GP_ERROR_NOT_FINITE, "time is inf",
         [](World& w) { return gpSetSceneTime(w.scene, double(inf), nullptr); }},
        {"gpSetSceneTime", "nothing that plays", GP_ERROR_INVALID_OPERATION, "playable",
         [](World& w) { return gpSetSceneTime(w.scene, 1, nullptr); }},
        {"gpGetSceneInfo", "no place for it", GP_ERROR_INVALID_ARGUMENT, "info is NULL",
         [](World& w) { return gpGetSceneInfo(w.scene, nullptr); }},
        {"gpDescribeScene", "no text for a size", GP_ERROR_INVALID_ARGUMENT, "text is NULL",
         [](World& w) { return gpDescribeScene(w.scene, nullptr, 10, nullptr); }},
        {"gpDescribeScene", "a buffer that is too small", GP_ERROR_INVALID_OPERATION, "size is 10",
         [](World& w) {
             char text[11] = "0123456789";
             const GpError error = gpDescribeScene(w.scene, text, 10, nullptr);
             return std::string(text) == "0123456789" ? error : GP_ERROR_UNKNOWN;
         }},
    };
    addHandleRows<GpDevice>(rows, "gpNewScene", "device",
                            [](World&, GpDevice d) { return made(gpNewScene(d)); });
    addHandleRows<GpScene>(rows, "gpReleaseScene", "scene",
                           [](World&, GpScene s) { return gpReleaseScene(s); });
    addHandleRows<GpScene>(rows, "gpLoadSceneFile", "scene", [](World&, GpScene s) {
        return gpLoadSceneFile(s, "nowhere.glb", nullptr);
    });
    addHandleRows<GpScene>(rows, "gpSetSceneTime", "scene",
                           [](World&, GpScene s) { return gpSetSceneTime(s, 0, nullptr); });
    addHandleRows<GpScene>(rows, "gpGetSceneInfo", "scene", [](World&, GpScene s) {
        GpSceneInfo info;
        return gpGetSceneInfo(s, &info);
    });
    addHandleRows<GpScene>(rows, "gpDescribeScene", "scene", [](World&, GpScene s) {
        size_t needed = 0;
        return gpDescribeScene(s, nullptr, 0, &needed);
    });
    return rows;
}

Rows cameraRows() {
    Rows rows = {
        {"gpGetSceneCamera", "past the end", GP_ERROR_OUT_OF_RANGE,
         "index is 0, but the scene has 0 cameras",
         [](World& w) {
             GpCameraDesc camera;
             return gpGetSceneCamera(w.scene, 0, &camera, nullptr);
         }},
        {"gpGetSceneCamera", "no place for it", GP_ERROR_INVALID_ARGUMENT, "camera is NULL",
         [](World& w) { return gpGetSceneCamera(w.scene, 0, nullptr, nullptr); }},
        {"gpFrameScene", "no place for it", GP_ERROR_INVALID_ARGUMENT, "camera is NULL",
         [](World& w) { return gpFrameScene(w.scene, 1, nullptr); }},
    };
    const auto add = [&](const char* what, float aspect, GpError expected) {
        rows.push_back({"gpFrameScene", what, expected, "aspect", [aspect](World& w) {
                            GpCameraDesc camera;
                            return gpFrameScene(w.scene, aspect, &camera);
                        }});
    };
    add("aspect 0", 0, GP_ERROR_OUT_OF_RANGE);
    add("aspect below 0", -1.5f, GP_ERROR_OUT_OF_RANGE);
    add("aspect NaN", nan, GP_ERROR_NOT_FINITE);
    add("aspect infinite", inf, GP_ERROR_NOT_FINITE);
    addHandleRows<GpScene>(rows, "gpGetSceneCamera", "scene", [](World&, GpScene s) {
        GpCameraDesc camera;
        return gpGetSceneCamera(s, 0, &camera, nullptr);
    });
    addHandleRows<GpScene>(rows, "gpFrameScene", "scene", [](World&, GpScene s) {
        GpCameraDesc camera;
        return gpFrameScene(s, 1, &camera);
    });
    return rows;
}

}  // namespace gp::test
