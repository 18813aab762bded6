#include "io/merl.h"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>

#include <fmt/format.h>

#include "io/file.h"
#include "merl_format.h"

namespace gp::io {
namespace {

namespace fs = std::filesystem;

// No surface reflects as much; sums and squares of it are still finite.
constexpr double largestValue = 1e9;

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
    throw FileError(FileError::Kind::invalid, path, what);
}

// By the first bytes and the size of a file.
void checkHead(const std::string& path, std::span<const std::byte> head, uintmax_t size) {
    if (head.size() < merl::headBytes)
        refuse(path, fmt::format("has only {} bytes: no MERL file", size));
    std::array<int32_t, 3> sizes;
    std::memcpy(sizes.data(), head.data(), sizeof(sizes));
    if (sizes != merl::sizes)
        refuse(path, fmt::format("its dimensions are {} x {} x {}, those of a MERL file 90 x 90 x "
                                 "180", sizes[0], sizes[1], sizes[2]));
    if (size != merl::fileBytes)
        refuse(path, fmt::format("is {} bytes long, {} than the {} of a MERL file", size,
                                 size < merl::fileBytes ? "shorter" : "longer", merl::fileBytes));
}

std::string describeNumber(size_t cell, size_t channel) {
    const auto [h, d, p] = merl::placeOf(cell);
    constexpr const char* names[] = {"red", "green", "blue"};
    return fmt::format("{} of the cell theta_h {}, theta_d {}, phi_d {}", names[channel], h, d, p);
}

// A file that is held somewhere is not read again: the same material in many places is one table.
struct SharedTable {
    fs::file_time_type written;
    std::weak_ptr<const MeasuredBrdf> brdf;
};
std::mutex sharedMutex;
std::map<std::string, SharedTable> sharedTables;

}  // namespace

bool isMerlName(std::string_view name) { return name.ends_with(".binary"); }

std::shared_ptr<const MeasuredBrdf> parseMerl(const std::string& path,
                                              std::span<const std::byte> bytes) {
    checkHead(path, bytes.first(std::min(bytes.size(), merl::headBytes)), bytes.size());
    LargeVector<float> cells(3 * merl::cellCount);
    bool measured = false;
    for (size_t channel = 0; channel < 3; ++channel) {
        const std::byte* plane =
            bytes.data() + merl::headBytes + channel * merl::cellCount * sizeof(double);
        for (size_t cell = 0; cell < merl::cellCount; ++cell) {
            double number;
            std::memcpy(&number, plane + cell * sizeof(double), sizeof(double));
            const double f = number * merl::scales[channel];
            if (!(std::abs(f) < largestValue))
                refuse(path, fmt::format("{} is {}", describeNumber(cell, channel), number));
            cells[3 * cell + channel] = float(f);
            measured = measured || f >= 0.0;
        }
    }
    if (!measured) refuse(path, "no cell of it was measured: all numbers are negative");
    return makeMeasuredBrdf(path, std::move(cells));
}

static std::shared_ptr<const MeasuredBrdf> readMerlAnew(const std::string& path) {
    std::error_code error;
    const uintmax_t size = fs::is_regular_file(path, error) ? fs::file_size(path, error) : 0;
    if (!error && size > merl::fileBytes) {  // whatever it is, it need not be read
        std::array<std::byte, merl::headBytes> head{};
        std::ifstream(path, std::ios::binary).read(reinterpret_cast<char*>(head.data()),
                                                   head.size());
        checkHead(path, head, size);
    }
    return parseMerl(path, readFile(path));
}

std::shared_ptr<const MeasuredBrdf> readMerl(const std::string& path) {
    std::error_code error;
    const fs::file_time_type written = fs::last_write_time(path, error);
    // Held while reading too: who wants the same file at the same time waits for it.
    const std::lock_guard lock(sharedMutex);
    if (const auto found = sharedTables.find(path); found != sharedTables.end()) {
        const auto known = found->second.brdf.lock();
        if (known && !error && found->second.written == written) return known;
        sharedTables.erase(found);
    }
    const auto brdf = readMerlAnew(path);
    sharedTables[path] = {written, brdf};
    return brdf;
}

void writeMerl(const std::string& path, std::span<const float> cells) {
    AtomicFile file(path);
    const std::string bytes = merl::fileOf(cells);
    file.write(std::as_bytes(std::span(bytes)));
    file.commit();
}

}  // namespace gp::io
