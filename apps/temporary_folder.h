// A folder for a while.
#pragma once

#include <string>

namespace gp::tool {

// Where temporary files belong; removed with all that is in it. Throws RunError.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::string operator()(const std::string& name) const { return m_path + "/" + name; }
    const std::string& path() const { return m_path; }

private:
    std::string m_path;
};

// All bytes of a file; none where it is missing.
std::string bytesOfFile(const std::string& path);

}  // namespace gp::tool
