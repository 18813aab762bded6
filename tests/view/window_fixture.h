// `glitterpath view` with its window, on a display without a screen: what all of its tests share.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "tool/tool_runner.h"
#include "virtual_display.h"

namespace gp::test {

using Words = std::vector<std::string>;

class WindowTest : public ::testing::Test {
protected:
    static void SetUpTestSuite() { s_display = std::make_unique<VirtualDisplay>(); }
    static void TearDownTestSuite() { s_display.reset(); }

    void SetUp() override {
        if (!s_display->isThere()) {
            GTEST_SKIP() << "Xvfb is not here (scripts/bootstrap installs it)";
        }
    }

    // `view` with these words, which has a script in the place of hands.
    ToolResult viewWith(const std::string& script, const Words& words) {
        writeText(m_folder("script.txt"), script);
        Words all = {"view", "--script", m_folder("script.txt"), "--quiet"};
        all.insert(all.end(), words.begin(), words.end());
        const ToolResult result = runTool(all);
        m_hasWindow = result.err.find("this build has no window") == std::string::npos;
        return result;
    }
    nlohmann::json state(const std::string& name) const { return readJson(m_folder(name)); }
    std::string file(const std::string& name) const { return m_folder(name); }

    TestFolder m_folder;
    bool m_hasWindow = true;
    inline static std::unique_ptr<VirtualDisplay> s_display;
};

}  // namespace gp::test

#define VIEW_OR_SKIP(result)                                                           \
    if (!m_hasWindow) GTEST_SKIP() << "this build has no window";                      \
    ASSERT_EQ((result).exitCode, 0) << (result).err
