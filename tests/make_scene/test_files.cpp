// The file as a file: complete or absent, small, the same every time, and clear refusals.
#include "glb_reader.h"
#include "make_scene/make_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>

namespace gp::make_scene {
namespace {

std::string messageOf(const MakeSceneOptions& options)
{
    try {
        makeScene(options);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "no error";
}

class EveryScene : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryScene, IsSmallAndTheSameToTheByteTwice)
{
    const std::string first = testing::outputPath("first-" + GetParam() + ".glb");
    const std::string second = testing::outputPath("second-" + GetParam() + ".glb");
    makeScene({GetParam(), first, {}});
    makeScene({GetParam(), second, {}});
    const std::vector<char> bytes = testing::readBytes(first);
    EXPECT_GT(bytes.size(), 1000u);
    EXPECT_LE(bytes.size(), 8u << 20);  // people download and keep them
    EXPECT_EQ(bytes, testing::readBytes(second));
    std::filesystem::remove(first);
    std::filesystem::remove(second);
}

std::vector<std::string> sceneNames()
{
    std::vector<std::string> names;
    for (const SceneInfo& scene : listScenes())
        names.push_back(scene.name);
    return names;
}

std::string testName(const ::testing::TestParamInfo<std::string>& scene)
{
    std::string name = scene.param;
    std::erase(name, '-');
    return name;
}

INSTANTIATE_TEST_SUITE_P(MakeScene, EveryScene, ::testing::ValuesIn(sceneNames()), testName);

TEST(MakeSceneFiles, UnknownSceneIsNamedWithTheKnownOnes)
{
    const std::string path = testing::outputPath("unknown.glb");
    const std::string message = messageOf({"still-live", path, {}});
    EXPECT_NE(message.find("'still-live'"), std::string::npos) << message;
    EXPECT_NE(message.find("still-life"), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(MakeSceneFiles, ParametersAreChecked)
{
    const std::string path = testing::outputPath("parameters.glb");
    EXPECT_NE(messageOf({"cornell", path, {{"rows", 3}}}).find("'rows'"), std::string::npos);
    EXPECT_NE(messageOf({"furnace", path, {{"rows", 0}}}).find("must lie in"), std::string::npos);
    EXPECT_NE(messageOf({"furnace", path, {{"rows", 2.5}}}).find("whole number"),
              std::string::npos);
    EXPECT_NE(messageOf({"closed-sphere", path, {{"albedo", std::nan("")}}}).find("must lie in"),
              std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(MakeSceneFiles, FailureToWriteLeavesNothingBehind)
{
    const std::string folder = testing::outputPath("no such folder");
    const std::string message = messageOf({"cornell", folder + "/x.glb", {}});
    EXPECT_NE(message.find("x.glb: cannot write"), std::string::npos) << message;
    // The target is a folder: the last step, the renaming, fails.
    const std::string target = testing::outputPath("is a folder.glb");
    std::filesystem::create_directory(target);
    std::filesystem::create_directory(target + "/occupied");
    EXPECT_NE(messageOf({"cornell", target, {}}).find("cannot write"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(target + ".part"));
    std::filesystem::remove_all(target);
}

TEST(MakeSceneFiles, DefaultsLieWithinTheirRanges)
{
    for (const SceneInfo& info : listScenes())
        for (const SceneParameter& parameter : info.parameters) {
            EXPECT_GE(parameter.defaultValue, parameter.minimum) << info.name << parameter.name;
            EXPECT_LE(parameter.defaultValue, parameter.maximum) << info.name << parameter.name;
            EXPECT_FALSE(parameter.description.empty());
        }
}

}  // namespace
}  // namespace gp::make_scene
