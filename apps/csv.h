// Comma-separated tables as spreadsheets write them (RFC 4180): fields may be quoted, and then
// contain commas, line ends and doubled quotes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gp::tool {

struct CsvRow {
    std::size_t line = 0;  // of the file, from 1
    std::vector<std::string> fields;
};

struct CsvTable {
    std::vector<std::string> columns;
    std::vector<CsvRow> rows;  // each as long as `columns`

    // The index of a column. Throws RunError naming `path` where there is none or more than one.
    std::size_t column(const std::string& path, std::string_view name) const;
};

// Empty lines are skipped. Throws RunError naming file and line.
CsvTable parseCsv(const std::string& path, std::string_view text);
CsvTable readCsv(const std::string& path);

// A row with its line end; fields are quoted where they must be.
std::string csvLine(const std::vector<std::string>& fields);

}  // namespace gp::tool
