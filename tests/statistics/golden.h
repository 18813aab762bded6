// Reads the golden values of ../shared/golden, numbers computed independently of this project.
// They do not ship with it: a test that needs them skips and says so where they are missing.
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace gp::test {

// One row: column name to text.
using GoldenRow = std::map<std::string, std::string>;

// Fields split at commas; a quoted field may contain them, "" in it stands for one quote.
inline std::vector<std::string> splitCsv(const std::string& line) {
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
            fields.back() += line[++i];
        } else if (line[i] == '"') {
            quoted = !quoted;
        } else if (line[i] == ',' && !quoted) {
            fields.emplace_back();
        } else if (line[i] != '\r') {
            fields.back() += line[i];
        }
    }
    return fields;
}

// Empty if the file is not there.
inline std::vector<GoldenRow> readGolden(const std::string& name) {
    const std::filesystem::path path =
        std::filesystem::path(GP_SOURCE_DIR) / ".." / "shared" / "golden" / name;
    std::ifstream in(path);
    std::vector<GoldenRow> rows;
    std::string line;
    if (!std::getline(in, line)) return rows;
    const std::vector<std::string> columns = splitCsv(line);
    while (std::getline(in, line)) {
        const std::vector<std::string> fields = splitCsv(line);
        if (fields.size() != columns.size()) continue;
        GoldenRow row;
        for (std::size_t i = 0; i < columns.size(); ++i) row[columns[i]] = fields[i];
        rows.push_back(row);
    }
    return rows;
}

inline float number(const GoldenRow& row, const std::string& column) {
    return std::stof(row.at(column));
}

// The value of "key" in the flat JSON object of a params column.
inline float jsonNumber(const std::string& json, const std::string& key) {
    const std::size_t at = json.find('"' + key + '"');
    if (at == std::string::npos) return 0.0f;
    return std::stof(json.substr(json.find(':', at) + 1));
}

}  // namespace gp::test

#define GP_SKIP_WITHOUT(rows, name) \
    if ((rows).empty()) GTEST_SKIP() << "../shared/golden/" << (name) << " is not there"
