// What the TOML parser does not limit itself: tables within tables by dotted keys. 100,000 of them
// are a file of 200 KB, and their destructors end the stack.
#pragma once

#include <cstddef>
#include <string_view>

namespace gp::io {

// The first line (from 1) with a key of more than `limit` parts; 0: there is none.
size_t lineWithLongKey(std::string_view text, size_t limit);

}  // namespace gp::io
