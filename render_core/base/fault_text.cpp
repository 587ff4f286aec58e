#include "render_core/base/fault_text.hpp"

#include <cstdio>

namespace tedavis::base {

FaultText fault_text(std::string_view what, std::uint64_t offset, std::string_view remedy) noexcept {
    char place[40];  // 32 with the longest number
    std::snprintf(place, sizeof place, " (offset %llu); ", static_cast<unsigned long long>(offset));
    FaultText text(what);
    text.append(place);
    text.append(remedy);
    return text;
}

std::string_view text_behind(std::string_view start, std::string_view message) noexcept {
    return message.substr(0, start.size()) == start ? message.substr(start.size()) : std::string_view();
}

}  // namespace tedavis::base
