// gnuplot as our hand, and the sheets of pictures that it draws.
#include <gtest/gtest.h>

#include <cstdlib>

#include "gnuplot.h"
#include "picture_grid.h"
#include "tool_error.h"
#include "tool_runner.h"

namespace gp::test {
namespace {

// An environment variable that is another one for a while.
class Environment {
public:
    Environment(const char* name, const std::string& value) : m_name(name) {
        const char* old = std::getenv(name);
        m_old = old == nullptr ? "" : old;
        setenv(name, value.c_str(), 1);
    }
    ~Environment() { m_old.empty() ? unsetenv(m_name) : setenv(m_name, m_old.c_str(), 1); }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

private:
    const char* m_name;
    std::string m_old;
};

tool::GridPicture halves(tool::Rgb8 upper, tool::Rgb8 lower) {
    tool::GridPicture picture;
    picture.title = "it's `touch x`, \"$(touch x)\"\nand alpha_x";
    picture.width = 40;
    picture.height = 30;
    picture.pixels.assign(600, upper);
    picture.pixels.insert(picture.pixels.end(), 600, lower);
    return picture;
}

// How many pixels of a PNG have one linear colour, and where they lie on average.
struct Patch {
    int count = 0;
    double x = 0, y = 0;
};

Patch findPatch(const std::string& path, float r, float g, float b) {
    unsigned width = 0, height = 0;
    const std::vector<float> rgba = readPicture(path, width, height);
    Patch patch;
    for (unsigned i = 0; i < width * height; ++i) {
        if (rgba[4 * i] == r && rgba[4 * i + 1] == g && rgba[4 * i + 2] == b) {
            ++patch.count;
            patch.x += i % width;
            patch.y += i / width;
        }
    }
    patch.x /= std::max(patch.count, 1);
    patch.y /= std::max(patch.count, 1);
    return patch;
}

TEST(PictureGrid, KeepsEveryPixelInItsPlace) {
    const TestFolder folder, temporary;
    const Environment environment("TMPDIR", temporary(""));
    tool::PictureGrid grid;
    grid.columns = 2;
    grid.title = "a title";
    grid.pictures = {halves({255, 0, 0}, {0, 255, 0}), halves({0, 0, 255}, {255, 255, 0}),
                     tool::GridPicture{}, halves({255, 0, 255}, {0, 255, 255})};
    grid.rowTitles = {"one", "two"};
    drawPictureGrid(grid, folder("sheet.png"));
    const Patch red = findPatch(folder("sheet.png"), 1, 0, 0);
    const Patch green = findPatch(folder("sheet.png"), 0, 1, 0);
    const Patch blue = findPatch(folder("sheet.png"), 0, 0, 1);
    const Patch cyan = findPatch(folder("sheet.png"), 0, 1, 1);
    for (const Patch& patch : {red, green, blue, cyan}) {
        EXPECT_LE(patch.count, 600);
        EXPECT_GE(patch.count, 38 * 13);  // gnuplot softens the outermost
    }
    EXPECT_NEAR(green.y - red.y, 15, 1);
    EXPECT_NEAR(green.x, red.x, 1);
    EXPECT_GT(blue.x, red.x + 40);
    EXPECT_NEAR(blue.y, red.y, 1);
    EXPECT_GT(cyan.y, green.y + 30);
    EXPECT_NEAR(cyan.x, blue.x, 1);
    EXPECT_EQ(folder.fileCount(), 1u);     // nobody ran what stands in the titles
    EXPECT_EQ(temporary.fileCount(), 0u);
}

TEST(PictureGrid, HasAxesAndAScale) {
    const TestFolder folder;
    tool::PictureGrid grid;
    grid.pictures = {halves({255, 0, 0}, {0, 255, 0})};
    drawPictureGrid(grid, folder("bare.png"));
    grid.axes = tool::PictureAxes{"x", "y", 0, 90, 0, 90, 30};
    grid.bar = tool::ColorBar{"bar", -1, 1, {{0, 0, 255}, {255, 255, 0}}};
    drawPictureGrid(grid, folder("sheet.png"));
    unsigned width = 0, height = 0, bareWidth = 0, bareHeight = 0;
    readPicture(folder("bare.png"), bareWidth, bareHeight);
    readPicture(folder("sheet.png"), width, height);
    EXPECT_GT(width, bareWidth);
    EXPECT_GT(height, bareHeight);
    const Patch low = findPatch(folder("sheet.png"), 0, 0, 1);
    const Patch high = findPatch(folder("sheet.png"), 1, 1, 0);
    EXPECT_GT(low.count, 100);
    EXPECT_GT(high.count, 100);
    EXPECT_GT(low.y, high.y);  // the minimum is below
    grid.axes->xLabel = "θ_h (degrees)";
    drawPictureGrid(grid, folder("sheet.svg"));
    EXPECT_NE(readText(folder("sheet.svg")).find("<svg"), std::string::npos);
}

TEST(Gnuplot, SaysWhatWentWrong) {
    const TestFolder folder;
    tool::GnuplotJob job;
    job.script = "plot nothing_of_this_name\n";
    try {
        drawWithGnuplot(job, folder("x.png"));
        FAIL() << "drew what cannot be drawn";
    } catch (const tool::RunError& error) {
        EXPECT_NE(std::string(error.what()).find("undefined variable"), std::string::npos)
            << error.what();
    }
    job.script = "plot x\n";
    EXPECT_THROW(drawWithGnuplot(job, folder("x.jpg")), tool::UsageError);
    EXPECT_THROW(drawWithGnuplot(job, folder("no/x.png")), tool::RunError);
    const Environment environment("PATH", folder(""));
    try {
        drawWithGnuplot(job, folder("x.png"));
        FAIL() << "drew without gnuplot";
    } catch (const tool::RunError& error) {
        EXPECT_STREQ(error.what(), "drawing needs gnuplot on the PATH (Debian: gnuplot-nox)");
    }
    EXPECT_EQ(folder.fileCount(), 0u);
}

}  // namespace
}  // namespace gp::test
