#include "brdf/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "csv.h"
#include "output.h"
#include "parse.h"
#include "reflectance.h"
#include "tool_error.h"

namespace gp::tool {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array kResults = {"r", "g", "b", "pdf"};

struct Columns {
    std::size_t model = 0, params = 0;
    std::array<std::size_t, 3> l{}, v{};
    std::vector<std::size_t> kept;  // all but those of the results
};

Columns findColumns(const std::string& path, const CsvTable& table) {
    Columns columns;
    columns.model = table.column(path, "model");
    columns.params = table.column(path, "params");
    const char* const axes[] = {"x", "y", "z"};
    for (std::size_t i = 0; i < 3; ++i) {
        columns.l[i] = table.column(path, fmt::format("l{}", axes[i]));
        columns.v[i] = table.column(path, fmt::format("v{}", axes[i]));
    }
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        if (std::find(kResults.begin(), kResults.end(), table.columns[i]) == kResults.end()) {
            columns.kept.push_back(i);
        }
    }
    return columns;
}

// A parameter as the library reads it: words and numbers as they are, lists with commas.
std::string wordOf(const std::string& name, const Json& value) {
    if (value.is_string()) {
        return value.get<std::string>();
    }
    const auto isNumber = [](const Json& part) { return part.is_number(); };
    if (value.is_array() && std::all_of(value.begin(), value.end(), isNumber)) {
        std::string word;
        for (const Json& part : value) {
            word += (word.empty() ? "" : ",") + part.dump();
        }
        return word;
    }
    if (!value.is_number() && !value.is_boolean()) {
        throw RunError(fmt::format("params: '{}' is {}, no value of a parameter", name,
                                   value.dump()));
    }
    return value.dump();
}

ParameterWords wordsOf(const std::string& params) {
    Json json;
    try {
        json = Json::parse(params);
    } catch (const Json::parse_error&) {
        throw RunError(fmt::format("params: '{}' is not JSON", params));
    }
    if (!json.is_object()) {
        throw RunError(fmt::format("params: '{}' is not a JSON object", params));
    }
    ParameterWords words;
    for (const auto& [name, value] : json.items()) {
        words.emplace_back(name, wordOf(name, value));
    }
    return words;
}

Direction directionOf(const CsvTable& table, const CsvRow& row,
                      const std::array<std::size_t, 3>& columns) {
    Direction d{};
    for (std::size_t i = 0; i < 3; ++i) {
        d[i] = parseNumber(table.columns[columns[i]], row.fields[columns[i]]);
    }
    if (d == Direction{}) {
        throw RunError(fmt::format("{}, {} and {} are 0: no direction", table.columns[columns[0]],
                                   table.columns[columns[1]], table.columns[columns[2]]));
    }
    return d;
}

class TableEvaluator {
public:
    TableEvaluator(const BrdfTableSettings& settings, const CsvTable& table)
        : m_settings(settings), m_table(table),
          m_columns(findColumns(settings.inputPath, table)), m_device(newModelDevice()) {}

    std::string headLine() const {
        std::vector<std::string> names;
        for (const std::size_t column : m_columns.kept) {
            names.push_back(m_table.columns[column]);
        }
        names.insert(names.end(), kResults.begin(), kResults.end());
        return csvLine(names);
    }

    std::string line(const CsvRow& row) {
        const Bsdf& bsdf = bsdfOf(row);
        const GpBsdfValue value = evaluate(m_device.get(), bsdf,
                                           directionOf(m_table, row, m_columns.l),
                                           directionOf(m_table, row, m_columns.v));
        std::vector<std::string> fields;
        for (const std::size_t column : m_columns.kept) {
            fields.push_back(row.fields[column]);
        }
        for (const float number : {value.f[0], value.f[1], value.f[2], value.pdf}) {
            fields.push_back(fmt::format("{}", number));
        }
        return csvLine(fields);
    }

    // Each once, with the first row that has it.
    void printNotices() const {
        for (const auto& [notice, line] : m_notices) {
            fmt::print(stderr, "glitterpath: note: {}:{}: {}\n", m_settings.inputPath, line,
                       notice);
        }
    }

private:
    // Rows of one model mostly follow each other, and a measured one is a large file.
    const Bsdf& bsdfOf(const CsvRow& row) {
        const std::string& model = row.fields[m_columns.model];
        const std::string& params = row.fields[m_columns.params];
        if (!m_bsdf || model != m_model || params != m_params) {
            m_bsdf.reset();
            m_bsdf = newBsdf(m_device.get(), model, m_settings.dialect, wordsOf(params));
            m_model = model;
            m_params = params;
            noteClamping(row, m_bsdf);
        }
        return m_bsdf;
    }

    void noteClamping(const CsvRow& row, const Bsdf& bsdf) {
        for (const Json& notice : describeBsdf(m_device.get(), bsdf).at("notices")) {
            m_notices.try_emplace(notice.get<std::string>(), row.line);
        }
    }

    const BrdfTableSettings& m_settings;
    const CsvTable& m_table;
    Columns m_columns;
    Device m_device;
    Bsdf m_bsdf;  // of the row before, made of these
    std::string m_model, m_params;
    std::map<std::string, std::size_t> m_notices;
};

}  // namespace

void evaluateTable(const BrdfTableSettings& settings) {
    checkWritable(settings.outputPath);
    const CsvTable table = readCsv(settings.inputPath);
    TableEvaluator evaluator(settings, table);
    std::string text = evaluator.headLine();
    for (const CsvRow& row : table.rows) {
        try {
            text += evaluator.line(row);
        } catch (const std::runtime_error& error) {
            throw RunError(fmt::format("{}:{}: {}", settings.inputPath, row.line, error.what()));
        }
    }
    writeText(settings.outputPath, text);
    evaluator.printNotices();
}

}  // namespace gp::tool
