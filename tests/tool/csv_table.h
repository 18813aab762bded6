// What the brdf tests share: tables as the tool writes them, and its errors.
#pragma once

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "csv.h"
#include "tool_runner.h"

namespace gp::test {

class Table {
public:
    struct Row {
        const tool::CsvTable* table;
        std::vector<std::string> fields;
        const std::string& text(const char* column) const {
            return fields[table->column("table", column)];
        }
        double number(const char* column) const { return std::stod(text(column)); }
    };

    explicit Table(const std::string& text) : m_table(tool::parseCsv("table", text)) {}
    std::vector<Row> rows() const {
        std::vector<Row> rows;
        for (const tool::CsvRow& row : m_table.rows) {
            rows.push_back({&m_table, row.fields});
        }
        return rows;
    }

private:
    tool::CsvTable m_table;
};

inline void expectError(const ToolResult& result, int exitCode, const std::string& says) {
    expectRefusal(result, exitCode, says);
    EXPECT_EQ(result.err.rfind("glitterpath: error: ", 0), 0u) << result.err;
    EXPECT_EQ(result.out, "");
}

}  // namespace gp::test
