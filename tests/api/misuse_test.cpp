// Runs every misuse row: the exact code, one line that names the call, and nothing changed.
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "api/world.h"

namespace gp::test {

namespace {

const Rows& allRows() {
    static const Rows rows = [] {
        Rows all;
        for (const Rows& some :
             {deviceRows(), textureRows(), materialRows(), meshRows(), instanceRows(), sceneRows(),
              lightRows(), environmentRows(), cameraRows(), frameRows(), renderRows(), imageRows(),
               bsdfRows(), drawRows(), immediateRows(), changeRows(), oceanRows()})
            all.insert(all.end(), some.begin(), some.end());
        return all;
    }();
    return rows;
}

// The names that the header declares.
std::set<std::string> declaredCalls() {
    std::ifstream file(GP_SOURCE_DIR "/include/glitterpath/glitterpath.h");
    std::stringstream text;
    text << file.rdbuf();
    const std::string header = text.str();
    const std::regex declaration(R"(GP_API[^;(]*?\b(gp[A-Z]\w*)\s*\()");
    std::set<std::string> names;
    for (std::sregex_iterator it(header.begin(), header.end(), declaration), end; it != end; ++it)
        names.insert((*it)[1]);
    return names;
}

// The first error of this thread, on the device or on none.
GpError recordedError(const World& w, std::string& message) {
    const char* text = nullptr;
    GpError code = gpGetError(w.device, &text);
    if (code == GP_SUCCESS) code = gpGetError(nullptr, &text);
    message = text ? text : "";
    return code;
}

void runRow(const Row& row) {
    World w;
    const std::string before = w.snapshot();
    const Outcome outcome = row.run(w);
    std::string message;
    const GpError recorded = recordedError(w, message);
    EXPECT_STREQ(gpErrorName(outcome.value_or(row.expected)), gpErrorName(row.expected))
        << message;
    const GpError noted = row.direct ? GP_SUCCESS : row.expected;
    EXPECT_STREQ(gpErrorName(recorded), gpErrorName(noted)) << message;
    if (noted != GP_SUCCESS) {
        EXPECT_EQ(message.find(row.call + ": "), 0u) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        EXPECT_LT(message.size(), 400u) << message;
    }
    if (!row.direct) {
        EXPECT_NE(message.find(row.message), std::string::npos) << message;
    }
    EXPECT_EQ(before, w.snapshot()) << "a failed call changed something";
}

TEST(Misuse, EveryRowGivesItsCodeAndChangesNothing) {
    for (const Row& row : allRows()) {
        SCOPED_TRACE(row.call + ": " + row.what);
        runRow(row);
    }
}

TEST(Misuse, ThereAreManyDifferentRows) {
    std::set<std::string> different;
    for (const Row& row : allRows()) different.insert(row.call + "/" + row.what);
    EXPECT_EQ(different.size(), allRows().size()) << "two rows have the same name";
    EXPECT_GE(different.size(), 150u);
    RecordProperty("rows", int(different.size()));
}

TEST(Misuse, EveryDeclaredCallHasRows) {
    std::map<std::string, int> rows;
    for (const Row& row : allRows()) ++rows[row.call];
    const std::set<std::string> declared = declaredCalls();
    EXPECT_GE(declared.size(), 40u) << "the header was not read rightly";
    for (const std::string& name : declared) EXPECT_GT(rows[name], 0) << name << " has no row";
    for (const auto& [name, count] : rows)
        EXPECT_TRUE(declared.contains(name)) << name << " is not in the header";
}

}  // namespace
}  // namespace gp::test
