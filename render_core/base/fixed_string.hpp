/// Text with a fixed capacity inside the object, always zero-terminated. Text that does not fit is cut at the capacity, and
/// cut() then returns true.
#pragma once

#include <cstddef>
#include <cstring>
#include <string_view>

namespace tedavis::base {

template <std::size_t N>
class FixedString {
public:
    FixedString() = default;
    FixedString(std::string_view text) { append(text); }
    FixedString(const char* text) { append(text); }

    void append(std::string_view text) {
        const std::size_t room = N - size_;
        const std::size_t count = text.size() < room ? text.size() : room;
        if (count > 0) std::memcpy(text_ + size_, text.data(), count);
        size_ += count;
        text_[size_] = '\0';
        cut_ = cut_ || count < text.size();
    }
    void clear() { *this = FixedString(); }

    [[nodiscard]] std::string_view view() const { return {text_, size_}; }
    [[nodiscard]] const char* c_str() const { return text_; }
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] bool empty() const { return size_ == 0; }
    [[nodiscard]] bool cut() const { return cut_; }
    friend bool operator==(const FixedString& a, const FixedString& b) { return a.view() == b.view(); }
    friend bool operator!=(const FixedString& a, const FixedString& b) { return !(a == b); }

private:
    char text_[N + 1]{};
    std::size_t size_ = 0;
    bool cut_ = false;
};

}  // namespace tedavis::base
