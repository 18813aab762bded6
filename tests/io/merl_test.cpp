// MERL files: read, written, refused.
#include <bit>
#include <limits>

#include <gtest/gtest.h>

#include "io/bsdf_source.h"
#include "io/load_helpers.h"
#include "io/merl.h"
#include "merl_format.h"
#include "scene/bsdf_evaluate.h"

using namespace gp;
using namespace gp::test;

namespace {

// Numbers that differ everywhere, with cells that were not measured.
const std::vector<float>& someCells() {
    static const std::vector<float> cells = [] {
        std::vector<float> list(3 * merl::cellCount);
        for (size_t i = 0; i < list.size(); ++i) {
            list[i] = (i / 3) % 7 == 3 ? -1.0f : 1e-4f * float((i * 7919) % 100'003);
        }
        return list;
    }();
    return cells;
}

std::span<const std::byte> bytesOf(const std::string& text) {
    return std::as_bytes(std::span(text));
}

std::string errorOf(const std::string& file) {
    try {
        io::parseMerl("some.binary", bytesOf(file));
    } catch (const io::FileError& e) {
        EXPECT_EQ(e.kind, io::FileError::Kind::invalid);
        EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
        EXPECT_TRUE(std::string(e.what()).starts_with("some.binary: ")) << e.what();
        return e.what();
    }
    return "no error";
}

void expectError(const std::string& file, const std::string& says) {
    EXPECT_NE(errorOf(file).find(says), std::string::npos) << errorOf(file);
}

// The example's file with one number changed.
std::string fileWith(size_t channel, size_t cell, double number) {
    std::string file = merl::fileOf(someCells());
    std::memcpy(file.data() + merl::headBytes + 8 * (channel * merl::cellCount + cell), &number,
                sizeof(number));
    return file;
}

}  // namespace

TEST(Merl, WhatIsWrittenIsRead) {
    const std::string path = inTemp("written.binary");
    io::writeMerl(path, someCells());
    EXPECT_EQ(std::filesystem::file_size(path), 34'992'012u);
    const auto brdf = io::readMerl(path);
    EXPECT_EQ(brdf->name, path);
    size_t different = 0, negative = 0;
    for (size_t i = 0; i < someCells().size(); ++i) {
        const float was = someCells()[i], is = brdf->words[i];
        different += was < 0.0f ? is >= 0.0f : is != was;
        negative += is < 0.0f;
    }
    EXPECT_EQ(different, 0u);
    EXPECT_GT(negative, 400'000u);
    std::filesystem::remove(path);
}

// By hand from the description of the format, not by our own writer.
TEST(Merl, PlanesAndScales) {
    std::string file(34'992'012, '\0');
    const int32_t sizes[3] = {90, 90, 180};
    std::memcpy(file.data(), sizes, 12);
    const size_t cell = 17 + 180 * (4 + 90 * 23);
    for (size_t channel = 0; channel < 3; ++channel) {
        const double number = 1500.0;
        std::memcpy(file.data() + 12 + 8 * (channel * 1'458'000 + cell), &number, 8);
    }
    const auto brdf = io::parseMerl("made.binary", bytesOf(file));
    EXPECT_FLOAT_EQ(brdf->words[3 * cell], 1.0f);
    EXPECT_FLOAT_EQ(brdf->words[3 * cell + 1], 1.15f);
    EXPECT_FLOAT_EQ(brdf->words[3 * cell + 2], 1.66f);
    EXPECT_EQ(brdf->words[3 * cell + 3], 0.0f);
    EXPECT_EQ(merl::placeOf(cell), (std::array<size_t, 3>{23, 4, 17}));
}

TEST(Merl, RefusesWhatIsNone) {
    const std::string good = merl::fileOf(someCells());
    EXPECT_EQ(errorOf(good), "no error");
    expectError("", "has only 0 bytes: no MERL file");
    expectError("short", "has only 5 bytes");
    expectError(good.substr(0, 12), "is 12 bytes long, shorter than the 34992012 of a MERL file");
    expectError(good.substr(0, good.size() - 8), "is 34992004 bytes long, shorter than");
    expectError(good + "x", "is 34992013 bytes long, longer than");
    std::string other = good;
    other[8] = 104, other[9] = 1;
    expectError(other, "its dimensions are 90 x 90 x 360, those of a MERL file 90 x 90 x 180");
    // The same number of cells.
    other = good;
    std::swap(other[0], other[8]);
    expectError(other, "its dimensions are 180 x 90 x 90");
}

TEST(Merl, RefusesNumbersThatAreNone) {
    const double infinity = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    expectError(fileWith(0, 0, nan), "red of the cell theta_h 0, theta_d 0, phi_d 0 is nan");
    expectError(fileWith(1, 180, infinity),
                "green of the cell theta_h 0, theta_d 1, phi_d 0 is inf");
    expectError(fileWith(2, merl::cellCount - 1, -infinity),
                "blue of the cell theta_h 89, theta_d 89, phi_d 179 is -inf");
    expectError(fileWith(0, 7, 1e300), "red of the cell theta_h 0, theta_d 0, phi_d 7 is 1e+300");
    expectError(merl::fileOf(std::vector<float>(3 * merl::cellCount, -1.0f)),
                "no cell of it was measured");
}

TEST(Merl, RefusesFilesThatAreNot) {
    const auto kindOf = [](const std::string& path) {
        try {
            io::readMerl(path);
        } catch (const io::FileError& e) {
            EXPECT_TRUE(std::string(e.what()).starts_with(path + ": ")) << e.what();
            return e.kind;
        }
        ADD_FAILURE() << path << " was read";
        return io::FileError::Kind::unsupported;
    };
    EXPECT_EQ(kindOf(inTemp("none.binary")), io::FileError::Kind::notFound);
    EXPECT_EQ(kindOf(inTemp("")), io::FileError::Kind::invalid);
    // Too large: refused by its head, without reading 10 GB of nothing.
    const std::string path = inTemp("large.binary");
    writeFile(path, Bytes(1));
    std::filesystem::resize_file(path, 10'000'000'000u);
    EXPECT_EQ(kindOf(path), io::FileError::Kind::invalid);
    std::filesystem::remove(path);
}

TEST(Merl, OneTableForAllThatHoldAFile) {
    const std::string path = inTemp("shared.binary");
    io::writeMerl(path, std::vector<float>(3 * merl::cellCount, 0.25f));
    auto first = io::readMerl(path);
    EXPECT_EQ(io::readMerl(path), first);
    io::writeMerl(path, std::vector<float>(3 * merl::cellCount, 0.5f));
    const auto changed = io::readMerl(path);
    EXPECT_NE(changed, first);
    EXPECT_EQ(changed->words[0], 0.5f);
    const std::weak_ptr<const MeasuredBrdf> old = first;
    first.reset();
    EXPECT_TRUE(old.expired());
    std::filesystem::remove(path);
    EXPECT_THROW(io::readMerl(path), io::FileError);
}

TEST(Merl, SettingsKeepTheTable) {
    const std::string path = inTemp("kept.binary");
    io::writeMerl(path, std::vector<float>(3 * merl::cellCount, 0.25f));
    auto settings = std::make_unique<BsdfSettings>(
        io::bsdfFromName(BsdfDialect::own, path, {{"base_color", "0.5,1,0"}}));
    std::filesystem::remove(path);
    EXPECT_EQ(settings->model->name, "measured");
    const std::weak_ptr<const MeasuredBrdf> table = settings->measured;
    auto copy = std::make_unique<const BsdfSettings>(*settings);
    settings.reset();
    const BsdfReading reading = evaluateBsdf(*copy, glm::normalize(glm::vec3(1, 0, 1)),
                                             glm::normalize(glm::vec3(-1, 1, 1)));
    EXPECT_FLOAT_EQ(reading.f.x, 0.125f);
    EXPECT_FLOAT_EQ(reading.f.y, 0.25f);
    EXPECT_EQ(reading.f.z, 0.0f);
    EXPECT_FALSE(table.expired());
    copy.reset();
    EXPECT_TRUE(table.expired());
}

TEST(Merl, TheModelWantsAFile) {
    try {
        io::bsdfFromName(BsdfDialect::own, "measured", {});
        FAIL() << "was made from nothing";
    } catch (const BsdfError& e) {
        EXPECT_EQ(std::string(e.what()), "measured: this model is made from a file, whose path is "
                                         "then the model's name (FILE.binary)");
    }
}
