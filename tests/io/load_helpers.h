// Loading of files that a test has just made.
#pragma once

#include <filesystem>

#include <gtest/gtest.h>
#include <unistd.h>

#include "io/gltf.h"
#include "io/sample_files.h"

namespace gp::test {

// A folder of this process's own, so that tests can run side by side.
inline std::string inTemp(const std::string& name) {
    const auto folder = std::filesystem::temp_directory_path() /
                        ("gp-test-io-" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    return (folder / name).string();
}

inline Scene load(const Bytes& file, const io::GltfOptions& options = {}) {
    const std::string path = inTemp("test.gltf");
    writeFile(path, file);
    Scene scene;
    io::loadGltf(path, options, scene);
    return scene;
}
inline Scene load(const GltfBuilder& b, const io::GltfOptions& options = {}) {
    return load(b.gltf(), options);
}
inline Scene loadAt(const GltfBuilder& b, double time, int animation = -1) {
    io::GltfOptions options;
    options.time = time;
    options.animation = animation;
    return load(b, options);
}

// The message without the path; checks that it is one line that begins with it, and that a scene
// that was there before is untouched.
inline std::string errorOf(const Bytes& file, const io::GltfOptions& options = {},
                           const std::string& name = "bad.gltf") {
    const std::string path = inTemp(name);
    writeFile(path, file);
    Scene scene;
    scene.instances.push_back(std::make_shared<Instance>());
    scene.warnings.push_back("old");
    scene.revision = 7;
    try {
        io::loadGltf(path, options, scene);
    } catch (const io::FileError& e) {
        const std::string what = e.what();
        EXPECT_TRUE(what.starts_with(path + ": ")) << what;
        EXPECT_EQ(what.find('\n'), std::string::npos) << what;
        EXPECT_EQ(scene.instances.size(), 1u);
        EXPECT_EQ(scene.warnings.size(), 1u);
        EXPECT_EQ(scene.revision, 7u);
        EXPECT_TRUE(scene.lights.empty() && scene.cameras.empty() && scene.sources.empty());
        return what.substr(path.size() + 2);
    }
    return "no error";
}
inline std::string errorOf(const GltfBuilder& b, const io::GltfOptions& options = {}) {
    return errorOf(b.gltf(), options);
}

inline glm::vec3 worldVertex(const Instance& i, uint32_t v) {
    return i.worldFromObject * glm::vec4(i.mesh->positions[v], 1);
}

inline void expectNear(glm::vec3 a, glm::vec3 b, float tolerance = 1e-5f) {
    EXPECT_LE(glm::length(a - b), tolerance) << a.x << " " << a.y << " " << a.z << " instead of "
                                             << b.x << " " << b.y << " " << b.z;
}

}  // namespace gp::test
