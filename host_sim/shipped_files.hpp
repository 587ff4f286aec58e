/// Finds the files that come with the program by short names, as in `--design cruise`.
#pragma once

#include <string>

namespace tedavis::host_sim {

/// The folder that holds `configs/`: $TEDAVIS_ROOT, else the place the program was built from. No trailing slash.
[[nodiscard]] std::string shipped_root();
/// Returns the path for the user's text: an existing path as it is; a bare name (no slash, no dot) as
/// `<root>/configs/<folder>/<name>.toml`; a name with slashes but without dots ("styles/lambert") as a path first, then likewise.
/// Throws UserError naming the shipped choices when neither exists.
[[nodiscard]] std::string resolve_config(const std::string& name_or_path, const std::string& folder);

/// Returns a path that the file `stated_in` names; a relative one is relative to its folder.
[[nodiscard]] std::string path_from(const std::string& stated_in, const std::string& path);
/// Returns the path of a configuration that another one, `stated_in`, names: a bare name is that of a shipped one, others are
/// paths relative to its folder.
[[nodiscard]] std::string stated_config(const std::string& name_or_path, const std::string& folder, const std::string& stated_in);

}  // namespace tedavis::host_sim
