/// Lists the names among which a user can choose, for a message.
#pragma once

#include <cstddef>
#include <string>

namespace tedavis::host_sim {

/// Names beyond this number are only counted, so that the message stays readable.
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

/// The end of a message about a name that a source of a scene does not have: the command that shows all names.
[[nodiscard]] inline std::string look_hint(const std::string& file) { return "; tedavis scene look " + file + " shows them"; }

}  // namespace tedavis::host_sim
