// Drawing with gnuplot: a script and its data in a temporary folder, a process, a picture.
#pragma once

#include <string>
#include <vector>

namespace gp::tool {

struct GnuplotFile {
    std::string name;   // as the script calls it
    std::string bytes;
};

struct GnuplotJob {
    unsigned width = 900, height = 600;  // pixels
    std::string script;                  // terminal and output are set already; UTF-8
    std::vector<GnuplotFile> files;      // in the folder where the script runs
};

// A text as a script takes it, in quotes; whatever it contains, it stays a text.
std::string gnuplotText(const std::string& text);

// Throws UsageError where the name ends in neither .png nor .svg, which is what can be drawn, and
// RunError where nothing can be written there.
void checkDrawable(const std::string& path);

// By the ending of the name; the file appears only when it is whole. Throws RunError with gnuplot's
// own words, or where there is no gnuplot.
void drawWithGnuplot(const GnuplotJob& job, const std::string& path);

}  // namespace gp::tool
