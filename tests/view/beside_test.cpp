// Two pictures in one: which pixel comes from which.
#include <gtest/gtest.h>

#include "beside.h"

namespace gp::test {
namespace {

using Values = std::vector<int>;

// A picture of one value everywhere.
Values flat(int value, std::size_t pixels) {
    return Values(4 * pixels, value);
}

Values firstChannel(const Values& pixels) {
    Values values;
    for (std::size_t i = 0; i < pixels.size(); i += 4) {
        values.push_back(pixels[i]);
    }
    return values;
}

Values both(double divider) {
    return firstChannel(tool::besideEachOther(flat(1, 12), flat(2, 12), 6, 2, divider,
                                              std::array<int, 4>{9, 9, 9, 9}));
}

TEST(Beside, LeftAndRightOfALine) {
    EXPECT_EQ(both(0.5), (Values{1, 1, 9, 9, 2, 2, 1, 1, 9, 9, 2, 2}));
    EXPECT_EQ(both(0.0), Values(12, 2));  // without a line
    EXPECT_EQ(both(1.0), Values(12, 1));
    EXPECT_EQ(both(7.0), Values(12, 1));
    EXPECT_EQ(both(1.0 / 6.0), (Values{9, 9, 2, 2, 2, 2, 9, 9, 2, 2, 2, 2}));
}

}  // namespace
}  // namespace gp::test
