// What the library tells of its denoisers: names and numbers for panels and scripts.
#pragma once

#include <glitterpath/glitterpath.h>

#include <string>
#include <vector>

namespace gp::tool::view {

struct DenoiserNumber {
    std::string name, meaning;
    float initial = 0, low = 0, high = 1;
    std::vector<std::string> usedBy;  // denoisers, "light reuse", ...
};

struct DenoiserFacts {
    std::vector<std::string> names;   // at the place of their GpDenoiser
    std::vector<DenoiserNumber> numbers;

    // Null where there is none of this name.
    const DenoiserNumber* number(const std::string& name) const;
    std::vector<std::string> numberNames() const;
    // The denoiser of this name; throws UsageError, `option` is what is to be blamed.
    GpDenoiser denoiser(const std::string& option, const std::string& name) const;
    std::string nameOf(GpDenoiser denoiser) const;  // "" for one that is not there
    bool isUsedBy(const DenoiserNumber& number, const std::string& user) const;
};

// Throws RunError.
DenoiserFacts describeDenoisers(GpDevice device);

}  // namespace gp::tool::view
