#include <filesystem>
#include <limits>

#include "api/world.h"

namespace gp::test {

namespace {

Row row(const char* what, GpError expected, const char* message, void (*change)(GpBsdfDesc&)) {
    return {"gpNewBsdf", what, expected, message, [change](World& w) {
                GpBsdfDesc desc{};
                desc.model = "half_lambert";
                change(desc);
                return made(gpNewBsdf(w.device, &desc));
            }};
}

std::string folderNamedLikeAFile() {
    const auto path = std::filesystem::temp_directory_path() / "gp-test-folder.binary";
    std::filesystem::create_directories(path);
    return path.string();
}

// One parameter of half_lambert.
Row parameterRow(const char* what, const char* message, const char* name, const char* value) {
    return {"gpNewBsdf", what, GP_ERROR_INVALID_ARGUMENT, message, [name, value](World& w) {
                const GpBsdfParameter parameter = {name, value};
                GpBsdfDesc desc{};
                desc.model = "half_lambert";
                desc.parameters = &parameter;
                desc.parameterCount = 1;
                return made(gpNewBsdf(w.device, &desc));
            }};
}

// One evaluation with a wrong component in wi or wo.
Row directionRow(const char* what, GpError expected, const char* message, float x, float z) {
    return {"gpEvaluateBsdf", what, expected, message, [x, z](World& w) {
                const float up[6] = {0, 0, 1, 0, 0, 1}, wrong[6] = {0, 0, 1, x, 0, z};
                GpBsdfValue values[2] = {{{5, 5, 5}, 5}, {{5, 5, 5}, 5}};
                const GpError error = gpEvaluateBsdf(w.bsdf, 2, up, wrong, values);
                return values[0].pdf == 5 ? error : GP_SUCCESS;  // a failed call changes nothing
            }};
}

// One sample with a wrong number in wo or u.
Row sampleRow(const char* what, GpError expected, const char* message, float z, float number) {
    return {"gpSampleBsdf", what, expected, message, [z, number](World& w) {
                const float wo[6] = {0, 0, 1, 0, 0, z}, u[6] = {0, 0, 0, 0.5f, 0.5f, number};
                GpBsdfSample samples[2] = {};
                samples[0].pdf = 5;
                const GpError error = gpSampleBsdf(w.bsdf, 2, wo, u, samples);
                return samples[0].pdf == 5 ? error : GP_SUCCESS;
            }};
}

void addSampleRows(Rows& rows) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    rows.push_back(sampleRow("a view that is NaN", GP_ERROR_NOT_FINITE, "wo[1][2] is nan", nan,
                             0.5f));
    rows.push_back(sampleRow("a view of no length", GP_ERROR_OUT_OF_RANGE, "wo[1] has no length",
                             0, 0.5f));
    rows.push_back(sampleRow("a random number of 1", GP_ERROR_OUT_OF_RANGE, "u[1][2] is 1", 1, 1));
    rows.push_back(sampleRow("a negative random number", GP_ERROR_OUT_OF_RANGE, "u[1][2] is -1",
                             1, -1));
    rows.push_back(sampleRow("a random number that is NaN", GP_ERROR_NOT_FINITE, "u[1][2] is nan",
                             1, nan));
    rows.push_back({"gpSampleBsdf", "no views", GP_ERROR_INVALID_ARGUMENT, "wo is NULL",
                    [](World& w) { return gpSampleBsdf(w.bsdf, 1, nullptr, nullptr, nullptr); }});
    rows.push_back({"gpSampleBsdf", "no random numbers", GP_ERROR_INVALID_ARGUMENT, "u is NULL",
                    [](World& w) {
                        const float up[3] = {0, 0, 1};
                        return gpSampleBsdf(w.bsdf, 1, up, nullptr, nullptr);
                    }});
    rows.push_back({"gpSampleBsdf", "nowhere to write", GP_ERROR_INVALID_ARGUMENT,
                    "samples is NULL", [](World& w) {
                        const float up[3] = {0, 0, 1}, u[3] = {0, 0, 0};
                        return gpSampleBsdf(w.bsdf, 1, up, u, nullptr);
                    }});
    rows.push_back({"gpSampleBsdf", "too many", GP_ERROR_TOO_LARGE, "count is 67108865",
                    [](World& w) {
                        return gpSampleBsdf(w.bsdf, 67108865, nullptr, nullptr, nullptr);
                    }});
    addHandleRows<GpBsdf>(rows, "gpSampleBsdf", "bsdf", [](World&, GpBsdf b) {
        const float up[3] = {0, 0, 1}, u[3] = {0, 0, 0};
        GpBsdfSample sample;
        return gpSampleBsdf(b, 1, up, u, &sample);
    });
}

void addDescriptionRows(Rows& rows) {
    rows.push_back({"gpDescribeBsdfModels", "a buffer that is too small",
                    GP_ERROR_INVALID_OPERATION, "size is 3", [](World& w) {
                        char text[3];
                        return gpDescribeBsdfModels(w.device, text, sizeof text, nullptr);
                    }});
    rows.push_back({"gpDescribeBsdfModels", "no buffer", GP_ERROR_INVALID_ARGUMENT, "text is NULL",
                    [](World& w) { return gpDescribeBsdfModels(w.device, nullptr, 9, nullptr); }});
    rows.push_back({"gpDescribeBsdf", "no buffer", GP_ERROR_INVALID_ARGUMENT, "text is NULL",
                    [](World& w) { return gpDescribeBsdf(w.bsdf, nullptr, 9, nullptr); }});
    rows.push_back({"gpDescribePresets", "no buffer", GP_ERROR_INVALID_ARGUMENT, "text is NULL",
                    [](World& w) {
                        return gpDescribePresets(w.device, nullptr, nullptr, 9, nullptr);
                    }});
    rows.push_back({"gpDescribePresets", "a file that is not there", GP_ERROR_FILE_NOT_FOUND,
                    "nowhere.toml", [](World& w) {
                        return gpDescribePresets(w.device, "nowhere.toml", nullptr, 0, nullptr);
                    }});
    addHandleRows<GpDevice>(rows, "gpDescribePresets", "device", [](World&, GpDevice d) {
        return gpDescribePresets(d, nullptr, nullptr, 0, nullptr);
    });
    addHandleRows<GpDevice>(rows, "gpDescribeBsdfModels", "device", [](World&, GpDevice d) {
        return gpDescribeBsdfModels(d, nullptr, 0, nullptr);
    });
    addHandleRows<GpBsdf>(rows, "gpDescribeBsdf", "bsdf", [](World&, GpBsdf b) {
        return gpDescribeBsdf(b, nullptr, 0, nullptr);
    });
}

}  // namespace

Rows bsdfRows() {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    Rows rows = {
        {"gpNewBsdf", "no descriptor", GP_ERROR_INVALID_ARGUMENT, "desc is NULL",
         [](World& w) { return made(gpNewBsdf(w.device, nullptr)); }},
        row("no model", GP_ERROR_INVALID_ARGUMENT, "model is NULL",
            [](GpBsdfDesc& d) { d.model = nullptr; }),
        row("an unknown model", GP_ERROR_INVALID_ARGUMENT,
            "unknown model 'phongg' (did you mean phong?)",
            [](GpBsdfDesc& d) { d.model = "phongg"; }),
        row("a model from a file without one", GP_ERROR_INVALID_ARGUMENT,
            "measured: this model is made from a file",
            [](GpBsdfDesc& d) { d.model = "measured"; }),
        row("a file that is not there", GP_ERROR_FILE_NOT_FOUND, "nowhere.binary: no such file",
            [](GpBsdfDesc& d) { d.model = "nowhere.binary"; }),
        row("a folder for a file", GP_ERROR_FILE_INVALID, ".binary: not a regular file",
            [](GpBsdfDesc& d) {
                static const std::string path = folderNamedLikeAFile();
                d.model = path.c_str();
            }),
        row("our name in another dialect", GP_ERROR_INVALID_ARGUMENT,
            "unknown model of dialect wdas 'half_lambert'",
            [](GpBsdfDesc& d) { d.dialect = GP_DIALECT_WDAS; }),
        row("an unknown dialect", GP_ERROR_INVALID_ARGUMENT, "dialect is 3",
            [](GpBsdfDesc& d) { d.dialect = anyEnum<GpBsdfDialect>(3); }),
        row("no parameters, but a count", GP_ERROR_INVALID_ARGUMENT, "parameters is NULL",
            [](GpBsdfDesc& d) { d.parameterCount = 2; }),
        parameterRow("a parameter without a name", "parameters[0].name is NULL", nullptr, "1"),
        parameterRow("a parameter without a value", "parameters[0].value is NULL", "wrap", nullptr),
        parameterRow("an unknown parameter", "unknown parameter of half_lambert 'wrapp' (did you",
                     "wrapp", "1"),
        parameterRow("a word for a number", "half_lambert: wrap: 'much' is not a finite number",
                     "wrap", "much"),
        directionRow("a direction that is NaN", GP_ERROR_NOT_FINITE, "wo[1][0] is nan", nan, 1),
        directionRow("a direction of no length", GP_ERROR_OUT_OF_RANGE, "wo[1] has no length", 0,
                     0),
        {"gpEvaluateBsdf", "no directions", GP_ERROR_INVALID_ARGUMENT, "wi is NULL",
         [](World& w) { return gpEvaluateBsdf(w.bsdf, 1, nullptr, nullptr, nullptr); }},
        {"gpEvaluateBsdf", "too many", GP_ERROR_TOO_LARGE, "count is 18446744073709551615",
         [](World& w) {
             const float up[3] = {0, 0, 1};
             GpBsdfValue value;
             return gpEvaluateBsdf(w.bsdf, SIZE_MAX, up, up, &value);
         }},
    };
    addDescriptionRows(rows);
    addSampleRows(rows);
    addHandleRows<GpDevice>(rows, "gpNewBsdf", "device", [](World&, GpDevice d) {
        GpBsdfDesc desc{};
        desc.model = "lambert";
        return made(gpNewBsdf(d, &desc));
    });
    addHandleRows<GpBsdf>(rows, "gpReleaseBsdf", "bsdf",
                          [](World&, GpBsdf b) { return gpReleaseBsdf(b); });
    addHandleRows<GpBsdf>(rows, "gpEvaluateBsdf", "bsdf", [](World&, GpBsdf b) {
        const float up[3] = {0, 0, 1};
        GpBsdfValue value;
        return gpEvaluateBsdf(b, 1, up, up, &value);
    });
    return rows;
}

}  // namespace gp::test
