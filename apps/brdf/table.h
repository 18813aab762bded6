// glitterpath brdf eval --csv: a table of models and directions gets its values.
#pragma once

#include <glitterpath/glitterpath.h>

#include <string>

namespace gp::tool {

struct BrdfTableSettings {
    std::string inputPath, outputPath = "-";
    GpBsdfDialect dialect = GP_DIALECT_OWN;
};

// The rows of the input with r, g, b and pdf at their ends. Throws RunError naming file and line of
// the first row that cannot be evaluated; then nothing is written.
void evaluateTable(const BrdfTableSettings& settings);

}  // namespace gp::tool
