/// The names among which a user can choose, in a sentence.
#pragma once

#include <cstddef>
#include <string>

namespace tedavis::host_sim {

/// More names than these are counted, so that a sentence stays one that can be read.
inline constexpr std::size_t kMaxChoicesNamed = 12;

/// "a, b, c and 5 more"; "none" of none. `names` is any container of texts, in the order in which they are stated.
template <class Names>
[[nodiscard]] std::string name_choices(const Names& names) {
    std::string list;
    std::size_t named = 0;
    for (const std::string& name : names) {
        if (named == kMaxChoicesNamed) break;
        list += (named++ == 0 ? "" : ", ") + name;
    }
    if (names.size() > named) list += " and " + std::to_string(names.size() - named) + " more";
    return list.empty() ? "none" : list;
}

/// What shows all of them: the end of a sentence about a name that a source of a scene does not have.
[[nodiscard]] inline std::string look_hint(const std::string& file) { return "; tedavis scene look " + file + " shows them"; }

}  // namespace tedavis::host_sim
