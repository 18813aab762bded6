#include "csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "tool_error.h"

namespace gp::tool {
namespace {

class CsvReader {
public:
    CsvReader(const std::string& path, std::string_view text) : m_path(path), m_text(text) {}

    // False at the end of the text.
    bool read(CsvRow& row) {
        while (m_at < m_text.size() && endsLine()) {
            skipLineEnd();
        }
        if (m_at >= m_text.size()) {
            return false;
        }
        row.line = m_line;
        row.fields.assign(1, "");
        while (m_at < m_text.size() && !endsLine()) {
            if (m_text[m_at] == ',') {
                ++m_at;
                row.fields.emplace_back();
            } else if (m_text[m_at] == '"') {
                readQuoted(row);
            } else {
                row.fields.back() += m_text[m_at++];
            }
        }
        return true;
    }

private:
    bool endsLine() const {
        return m_text[m_at] == '\n' || m_text.substr(m_at, 2) == "\r\n";
    }

    void skipLineEnd() {
        m_at += m_text[m_at] == '\r' ? 2 : 1;
        ++m_line;
    }

    void readQuoted(CsvRow& row) {
        ++m_at;
        for (;; ++m_at) {
            if (m_at >= m_text.size()) {
                throw RunError(fmt::format("{}:{}: a quote is not closed", m_path, row.line));
            }
            if (m_text[m_at] == '"') {
                if (m_text.substr(m_at, 2) != "\"\"") {
                    break;
                }
                ++m_at;
            }
            m_line += m_text[m_at] == '\n' ? 1 : 0;
            row.fields.back() += m_text[m_at];
        }
        ++m_at;
    }

    const std::string& m_path;
    std::string_view m_text;
    std::size_t m_at = 0, m_line = 1;
};

}  // namespace

std::size_t CsvTable::column(const std::string& path, std::string_view name) const {
    const auto found = std::find(columns.begin(), columns.end(), name);
    if (found == columns.end()) {
        throw RunError(fmt::format("{}: there is no column '{}'", path, name));
    }
    if (std::find(found + 1, columns.end(), name) != columns.end()) {
        throw RunError(fmt::format("{}: there are two columns '{}'", path, name));
    }
    return static_cast<std::size_t>(found - columns.begin());
}

CsvTable parseCsv(const std::string& path, std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) {
        text.remove_prefix(3);  // the mark that some programs put before UTF-8
    }
    CsvReader reader(path, text);
    CsvTable table;
    CsvRow row;
    if (!reader.read(row)) {
        throw RunError(fmt::format("{}: is empty, it should begin with the columns' names", path));
    }
    table.columns = row.fields;
    while (reader.read(row)) {
        if (row.fields.size() != table.columns.size()) {
            throw RunError(fmt::format("{}:{}: has {} fields, but there are {} columns", path,
                                       row.line, row.fields.size(), table.columns.size()));
        }
        table.rows.push_back(row);
    }
    return table;
}

CsvTable readCsv(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    const bool empty = file && file.peek() == std::ifstream::traits_type::eof();
    std::ostringstream text;
    // A folder can be opened, but not read; of an empty file nothing can be passed on.
    if (file.bad() || !file.is_open() || (!empty && !(text << file.rdbuf()))) {
        throw RunError(fmt::format("{}: cannot read: {}", path, std::strerror(errno)));
    }
    return parseCsv(path, text.str());
}

std::string csvLine(const std::vector<std::string>& fields) {
    std::string line;
    for (const std::string& field : fields) {
        line += line.empty() ? "" : ",";
        if (field.find_first_of(",\"\r\n") == std::string::npos) {
            line += field;
            continue;
        }
        line += '"';
        for (const char c : field) {
            line += c;
            if (c == '"') {
                line += c;
            }
        }
        line += '"';
    }
    return line + "\n";
}

}  // namespace gp::tool
