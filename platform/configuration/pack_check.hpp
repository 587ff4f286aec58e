/// A pack: one folder with a configuration and all that it names, as `tedavis pack` writes it, from which desk and board start.
///
///     pack.toml            the manifest
///     pack.toml.minisig    its signature, where it was signed
///     config.toml          the configuration (display_config.hpp), with names from this folder
///     ...                  the files that the configuration names
///
/// The manifest:
///
///     title = "..."
///     made = "2026-11-30T09:00:00Z"
///     made_by = "tedavis 0.1.0 ..."
///     valid_from = "2026-12-01"      UTC days on which the data may be used, both included; either may be absent
///     valid_until = "2026-12-28"
///     [[file]]                       each file of the folder but the manifest and its signature
///     path = "terrain/area.tdb"
///     bytes = 1234
///     sha256 = "64 digits"
///     origin = "/data/area.tdb"      where it was copied from
///     sources = "..."                what the database says of its sources; may be absent
///     valid_from, valid_until        as above, where the file states them
///
/// Memory  start-up only (allocates). Failure  one sentence that names the file.
#pragma once

#include <cstdint>
#include <string_view>
#include <type_traits>

#include "platform/configuration/config_path.hpp"
#include "platform/configuration/utc_day.hpp"
#include "render_core/base/error.hpp"
#include "render_core/base/result.hpp"
#include "render_core/base/valid_period.hpp"

namespace tedavis::platform {

inline constexpr const char* kPackManifest = "pack.toml";
inline constexpr const char* kPackSignature = "pack.toml.minisig";
inline constexpr const char* kPackConfig = "config.toml";
/// The key that packs must be signed with, where this file exists.
inline constexpr const char* kInstalledPackKey = "/etc/tedavis/pack.pub";

/// What was found in a pack whose files are as its manifest says.
struct CheckedPack {
    Path folder;  ///< ends in a slash; empty: there is no pack
    base::FixedString<95> title;
    std::uint64_t files = 0, bytes = 0;
    bool is_signed = false;  ///< with the key that was asked for
    /// The latest begin and the earliest end of what the manifest states; the names say of which file, and are empty for the
    /// pack.
    DayText valid_from, valid_until;
    base::FixedString<255> valid_from_of, valid_until_of;
    /// Of the identities and times of change of folder, manifest and files: confirm_pack() compares it, and so finds a pack that
    /// was replaced after it was checked.
    std::uint64_t seal = 0;

    [[nodiscard]] bool is_pack() const { return !folder.empty(); }
};
static_assert(std::is_trivially_copyable_v<CheckedPack>);

/// Why a configuration or a pack is refused.
struct ConfigError : base::Error {
    bool may_pass = false;  ///< it changed while it was read, so that another try may find it whole
};

/// Reads the manifest and compares the folder's names with it. What the files hold is not read, and a listed file may be
/// missing; a file that is not listed is an error.
[[nodiscard]] base::Result<CheckedPack, base::Error> list_pack(std::string_view folder);

/// Compares each file of the folder with the manifest: size and SHA-256; a file that is changed, missing or not listed is an
/// error, and so is a link. Where anything lies at `public_key`, the manifest must be signed with that key; null: no key is
/// looked for.
[[nodiscard]] base::Result<CheckedPack, ConfigError> check_pack(std::string_view folder, const char* public_key);

/// To be called when all files of the pack are open: an error says that one was written or replaced since it was checked. Without
/// a pack there is none.
[[nodiscard]] base::Error confirm_pack(const CheckedPack& pack);

/// The error of a start from the pack: that it changed, where confirm_pack() says so; else the one that is given.
[[nodiscard]] ConfigError fault_of_start(const CheckedPack& pack, const base::Error& error);

/// The period in which all data of the pack may be used; open where there is no pack.
[[nodiscard]] base::ValidPeriod valid_period(const CheckedPack& pack);
/// One sentence where an instant lies outside of this period; else empty, as for an instant that is no date, since the clock was
/// not set (base::can_be_utc).
[[nodiscard]] base::FixedString<511> words_of_age(const CheckedPack& pack, base::Time utc);

struct FoundConfig {
    Path file;         ///< the configuration file
    CheckedPack pack;  ///< is_pack() is false where the file is of none
};
/// What a command line names: a configuration file, or the folder of a pack. A file that lies beside a manifest is of a pack,
/// too. A file of no pack is not checked, also where there is a key.
[[nodiscard]] base::Result<FoundConfig, ConfigError> find_config(const char* named, const char* public_key);

}  // namespace tedavis::platform
