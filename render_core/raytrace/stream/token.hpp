/// The words of a token stream: literals, and calls in post-order (thesis 6.2.2.1; Middendorf 2014).
///
/// `a1 .. an f` is a call of f with n literals; its output replaces it. A call may stand for several: `a1 .. an b1 .. bn f x 2`
/// is `a1 .. an f b1 .. bn f`, written shorter. A literal uses all 32 bits; whether a word is a call is stored separately.
#pragma once

#include <cstdint>
#include <cstring>

namespace tedavis::raytrace {

using TaskId = std::uint8_t;

inline constexpr std::uint32_t kMaxTasks = 64;
inline constexpr TaskId kNoTask = 255;
inline constexpr std::uint32_t kMaxPatternWords = 4096;  ///< a call with its arguments
inline constexpr std::uint32_t kMaxOutputWords = 16384;  ///< largest output of a token, for all calls that it stands for

struct Token {
    std::uint32_t word = 0;
    bool is_call = false;

    friend bool operator==(const Token& a, const Token& b) { return a.word == b.word && a.is_call == b.is_call; }
    friend bool operator!=(const Token& a, const Token& b) { return !(a == b); }
};

/// `count` 1 to 2^24 - 1; tasks allow fewer (TaskNetwork::most_count).
[[nodiscard]] constexpr std::uint32_t call_word(TaskId task, std::uint32_t count = 1) { return task | count << 8; }
[[nodiscard]] constexpr TaskId called_task(std::uint32_t call) { return static_cast<TaskId>(call & 255); }
[[nodiscard]] constexpr std::uint32_t call_count(std::uint32_t call) { return call >> 8; }

[[nodiscard]] constexpr Token literal(std::uint32_t word) { return {word, false}; }
[[nodiscard]] constexpr Token call(TaskId task, std::uint32_t count = 1) { return {call_word(task, count), true}; }

[[nodiscard]] inline std::uint32_t word_of(float value) {
    std::uint32_t word = 0;
    std::memcpy(&word, &value, sizeof word);
    return word;
}
[[nodiscard]] inline float float_of(std::uint32_t word) {
    float value = 0;
    std::memcpy(&value, &word, sizeof value);
    return value;
}

}  // namespace tedavis::raytrace
