/// Why the board program cannot do what it was asked: one sentence, what, where, what to do.
#pragma once

#include <initializer_list>
#include <string_view>

#include "render_core/base/fixed_string.hpp"

namespace tedavis::target {

struct BoardError {
    base::FixedString<1535> sentence;
};

/// The parts joined; what does not fit is cut.
[[nodiscard]] inline BoardError make_board_error(std::initializer_list<std::string_view> parts) {
    BoardError error;
    for (const std::string_view part : parts) error.sentence.append(part);
    return error;
}

}  // namespace tedavis::target
