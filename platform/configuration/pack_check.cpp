#include "platform/configuration/pack_check.hpp"

#include <dirent.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>

#include "platform/configuration/minisign.hpp"
#include "platform/configuration/sha256.hpp"
#include "platform/files/file_byte_source.hpp"
#include "platform/files/file_text.hpp"
#include "render_core/base/config_reader.hpp"
#include "render_core/base/hash.hpp"
#include "render_core/base/utc_time.hpp"

namespace tedavis::platform {
namespace {

constexpr std::int64_t kMaxFileBytes = std::int64_t{1} << 60;

enum class Found : std::uint8_t { nothing, file, folder, other };

/// Nothing lies at a path only where the system says so: what cannot be looked at is an error.
base::Result<Found, base::Error> look_at(const char* path) {
    struct stat status {};
    if (::lstat(path, &status) == 0)
        return S_ISREG(status.st_mode) ? Found::file : S_ISDIR(status.st_mode) ? Found::folder : Found::other;
    if (errno == ENOENT) return Found::nothing;
    return base::fail(base::make_error(path, ": cannot be looked at (", std::strerror(errno), "); check it"));
}

/// Relative, and not out of the folder.
bool is_inside(std::string_view path) {
    return !path.empty() && path.front() != '/' && path.substr(0, 3) != "../" && path != ".." &&
           path.find("/../") == std::string_view::npos && path.find("//") == std::string_view::npos && path.back() != '/' &&
           (path.size() < 3 || path.substr(path.size() - 3) != "/..");
}

Path path_in(const CheckedPack& pack, std::string_view name) {
    Path path = pack.folder;
    path.append(name);
    return path;
}

/// What changes when a file is written, replaced or renamed.
void add_identity(const char* path, base::Fnv1a64& seal) {
    struct stat status {};
    static_cast<void>(::stat(path, &status));
    const std::int64_t parts[] = {static_cast<std::int64_t>(status.st_dev),
                                  static_cast<std::int64_t>(status.st_ino),
                                  static_cast<std::int64_t>(status.st_size),
                                  status.st_ctim.tv_sec,
                                  status.st_ctim.tv_nsec,
                                  status.st_mtim.tv_sec,
                                  status.st_mtim.tv_nsec};
    seal.add(parts, sizeof parts);
}

class Manifest {
public:
    Manifest(std::string_view text, const CheckedPack& pack)
        : pack_(pack), file_(path_in(pack, kPackManifest)), reader_(text, file_.view()) {}

    base::Error read() {
        base::ConfigSection root = reader_.root();
        pack_.title.append(root.text("title"));
        static_cast<void>(root.text("made"));
        static_cast<void>(root.text("made_by"));
        narrow_dates(root, {});
        pack_.files = root.table_count("file");
        for (std::size_t n = 0; n < pack_.files; ++n) read_entry(root.table_at("file", n));
        if (!reader_.finish()) return reader_.error();
        if (lists(kPackConfig)) return {};
        return base::make_error(file_.view(), ": lists no ", kPackConfig, "; pack again");
    }

    base::Error check_files() {
        base::ConfigSection root = reader_.root();
        for (std::size_t n = 0; n < pack_.files; ++n)
            if (base::Error error = check_file(root.table_at("file", n))) return error;
        return {};
    }

    /// In each folder on the way to a listed file.
    base::Error find_others() {
        if (base::Error error = find_others_in({})) return error;
        base::ConfigSection root = reader_.root();
        std::string_view before;
        for (std::size_t n = 0; n < pack_.files; ++n) {
            const std::string_view path = root.table_at("file", n).text("path");
            for (std::size_t at = path.find('/'); at != std::string_view::npos; at = path.find('/', at + 1)) {
                const std::string_view folder = path.substr(0, at + 1);
                if (before.substr(0, folder.size()) == folder) continue;  // looked into already
                if (base::Error error = find_others_in(folder)) return error;
            }
            before = path;
        }
        return {};
    }

    [[nodiscard]] std::uint64_t seal() {
        base::Fnv1a64 seal;
        add_identity(pack_.folder.c_str(), seal);
        add_identity(file_.c_str(), seal);
        base::ConfigSection root = reader_.root();
        for (std::size_t n = 0; n < root.table_count("file"); ++n)
            add_identity(path_in(pack_, root.table_at("file", n).text("path")).c_str(), seal);
        return seal.value();
    }

    [[nodiscard]] const CheckedPack& pack() const { return pack_; }

private:
    void read_entry(base::ConfigSection entry) {
        const std::string_view path = entry.text("path");
        if (!is_inside(path)) return entry.fault("path", "is no path within the pack; pack again");
        if (path_in(pack_, path).cut()) entry.fault("path", "the path is longer than 1023 bytes; use a shorter one");
        if (times_listed(path) > 1) entry.fault("path", "is listed twice; pack again");
        pack_.bytes += static_cast<std::uint64_t>(entry.integer("bytes", 0, kMaxFileBytes));
        if (entry.text("sha256").size() != 64) entry.fault("sha256", "is no SHA-256 of 64 digits; pack again");
        static_cast<void>(entry.text("origin", ""));
        static_cast<void>(entry.text("sources", ""));
        narrow_dates(entry, path);
    }

    void narrow_dates(base::ConfigSection& section, std::string_view of) {
        const DayText from = day_at(section, "valid_from"), until = day_at(section, "valid_until");
        if (!from.empty() && from.view() > pack_.valid_from.view()) {
            pack_.valid_from = from;
            pack_.valid_from_of = of;
        }
        if (!until.empty() && (pack_.valid_until.empty() || until.view() < pack_.valid_until.view())) {
            pack_.valid_until = until;
            pack_.valid_until_of = of;
        }
    }

    static DayText day_at(base::ConfigSection& section, std::string_view key) {
        const std::string_view text = section.text(key, "");
        if (text.empty() || is_day(text)) return text;
        section.fault(key, "is no day; write it as \"2026-12-28\"");
        return {};
    }

    base::Error check_file(base::ConfigSection entry) const {
        const Path path = path_in(pack_, entry.text("path"));
        auto file = open_file(path.c_str());
        if (!file.ok()) return base::make_error(file.error().message.view(), "; the pack's manifest lists it");
        const auto listed = static_cast<std::uint64_t>(entry.integer("bytes", 0, kMaxFileBytes));
        if (file.value().size() != listed)
            return base::make_error(path.view(), ": has ", base::digits(file.value().size()).view(), " bytes, and ",
                                    base::digits(listed).view(), " by the pack's manifest; copy the pack again");
        Sha256Digest digest{};
        if (!hash_source(file.value(), digest))
            return base::make_error(path.view(), ": cannot be read to its end; check the medium");
        if (hex_of(digest).view() == entry.text("sha256")) return {};
        return base::make_error(path.view(),
                                ": was changed after packing (its SHA-256 is not the manifest's); copy the pack again");
    }

    [[nodiscard]] std::size_t times_listed(std::string_view name) {
        base::ConfigSection root = reader_.root();
        std::size_t times = 0;
        for (std::size_t n = 0; n < pack_.files; ++n)
            if (root.table_at("file", n).text("path") == name) ++times;
        return times;
    }

    [[nodiscard]] bool lists(std::string_view name) { return times_listed(name) > 0; }

    /// A folder on the way to a listed file.
    [[nodiscard]] bool leads_on(std::string_view folder) {
        base::ConfigSection root = reader_.root();
        for (std::size_t n = 0; n < pack_.files; ++n) {
            const std::string_view path = root.table_at("file", n).text("path");
            if (path.size() > folder.size() && path.substr(0, folder.size()) == folder && path[folder.size()] == '/') return true;
        }
        return false;
    }

    base::Error find_others_in(std::string_view folder) {
        const Path path = path_in(pack_, folder);
        DIR* const entries = ::opendir(path.c_str());
        if (entries == nullptr && errno == ENOENT) return {};  // check_files() says which file is missing
        if (entries == nullptr) return base::make_error(path.view(), ": cannot be read (", std::strerror(errno), "); check it");
        base::Error error;
        while (const dirent* const entry = error ? nullptr : ::readdir(entries)) {
            const std::string_view name = entry->d_name;
            if (name == "." || name == ".." || (folder.empty() && (name == kPackManifest || name == kPackSignature))) continue;
            Path within(folder);
            within.append(name);
            error = refuse_other(within.view());
        }
        ::closedir(entries);
        return error;
    }

    /// A link might lead out of the pack.
    base::Error refuse_other(std::string_view name) {
        const Path path = path_in(pack_, name);
        const bool is_listed = lists(name);
        if (!is_listed && !leads_on(name))
            return base::make_error(path.view(), ": is not listed by the pack's manifest; remove it, or pack again");
        const auto found = look_at(path.c_str());
        if (!found.ok()) return found.error();
        if (found.value() == (is_listed ? Found::file : Found::folder)) return {};
        return base::make_error(path.view(), is_listed ? ": is no regular file; " : ": is no folder; ",
                                "a pack holds files and folders, and no links, so pack again");
    }

    CheckedPack pack_;
    Path file_;
    base::ConfigReader reader_;
};

base::Error check_signature_of(std::string_view text, CheckedPack& pack, const char* public_key) {
    if (public_key == nullptr) return {};
    const auto key = look_at(public_key);
    if (!key.ok()) return key.error();
    if (key.value() == Found::nothing) return {};
    if (base::Error error = verify_minisign(text, path_in(pack, kPackManifest).view(), public_key)) return error;
    pack.is_signed = true;
    return {};
}

/// Of what is read before the files are known.
std::uint64_t seal_of_head(const CheckedPack& pack) {
    base::Fnv1a64 seal;
    for (const char* name : {"", kPackManifest, kPackSignature}) add_identity(path_in(pack, name).c_str(), seal);
    return seal.value();
}

base::Error changed_pack(const CheckedPack& pack) {
    return base::make_error(pack.folder.view(), ": was replaced or changed during the start; start again");
}

base::Failure<ConfigError> refused(const base::Error& error, bool may_pass = false) {
    return base::fail(ConfigError{error, may_pass});
}

base::Result<FileText, base::Error> read_manifest(const CheckedPack& pack) {
    const Path path = path_in(pack, kPackManifest);
    if (path.cut()) return base::fail(base::make_error(path.view(), ": the path is too long; use a shorter one"));
    const auto found = look_at(path.c_str());
    if (!found.ok()) return base::fail(found.error());
    if (found.value() == Found::nothing)
        return base::fail(base::make_error(pack.folder.view(), ": is no pack, for it has no ", kPackManifest,
                                           "; name a folder that tedavis pack wrote, or a configuration file"));
    return read_file_text(path.c_str());
}

CheckedPack pack_at(std::string_view folder) {
    CheckedPack pack;
    pack.folder.append(folder);
    if (folder.empty() || folder.back() != '/') pack.folder.append("/");
    return pack;
}

}  // namespace

base::Result<CheckedPack, base::Error> list_pack(std::string_view folder) {
    const CheckedPack pack = pack_at(folder);
    const auto text = read_manifest(pack);
    if (!text.ok()) return base::fail(text.error());
    Manifest manifest(text.value().view(), pack);
    if (base::Error error = manifest.read()) return base::fail(error);
    if (base::Error error = manifest.find_others()) return base::fail(error);
    return manifest.pack();
}

base::Result<CheckedPack, ConfigError> check_pack(std::string_view folder, const char* public_key) {
    CheckedPack pack = pack_at(folder);
    const std::uint64_t head = seal_of_head(pack);
    const auto text = read_manifest(pack);
    if (!text.ok()) return refused(text.error());
    const base::Error unsigned_pack = check_signature_of(text.value().view(), pack, public_key);
    if (unsigned_pack && seal_of_head(pack) != head) return refused(changed_pack(pack), true);
    if (unsigned_pack) return refused(unsigned_pack);
    Manifest manifest(text.value().view(), pack);
    if (base::Error error = manifest.read()) return refused(error);
    const std::uint64_t seal = manifest.seal();
    base::Error error = manifest.check_files();
    if (!error) error = manifest.find_others();
    if (error && (seal_of_head(pack) != head || manifest.seal() != seal)) return refused(changed_pack(pack), true);
    if (error) return refused(error);
    pack = manifest.pack();
    pack.seal = seal;
    return pack;
}

base::Error confirm_pack(const CheckedPack& pack) {
    if (!pack.is_pack()) return {};
    const auto text = read_manifest(pack);
    if (!text.ok()) return text.error();
    if (Manifest(text.value().view(), pack).seal() == pack.seal) return {};
    return changed_pack(pack);
}

ConfigError fault_of_start(const CheckedPack& pack, const base::Error& error) {
    const base::Error change = confirm_pack(pack);
    return change ? ConfigError{change, true} : ConfigError{error};
}

base::ValidPeriod valid_period(const CheckedPack& pack) {
    base::ValidPeriod period;
    if (!pack.valid_from.empty()) period.begin = start_of_day(pack.valid_from.view());
    if (!pack.valid_until.empty()) period.end = start_of_day(pack.valid_until.view()) + kUtcDay;
    return period;
}

base::FixedString<511> words_of_age(const CheckedPack& pack, base::Time utc) {
    base::FixedString<511> words;
    const base::Currency currency = base::currency_at(valid_period(pack), utc);
    if (!base::can_be_utc(utc) || currency == base::Currency::current) return words;
    const bool is_early = currency == base::Currency::not_yet_valid;
    const auto& of = is_early ? pack.valid_from_of : pack.valid_until_of;
    const DayText day = day_of(utc.ns);
    for (const std::string_view part :
         {pack.folder.view(), of.view(), std::string_view(is_early ? ": is valid from " : ": was valid until "),
          is_early ? pack.valid_from.view() : pack.valid_until.view(), std::string_view(", and this is "), day.view(),
          std::string_view("; get data for this day")})
        words.append(part);
    return words;
}

base::Result<FoundConfig, ConfigError> find_config(const char* named, const char* public_key) {
    struct stat status {};
    const bool is_folder = ::stat(named, &status) == 0 && S_ISDIR(status.st_mode);
    FoundConfig found;
    Path folder = is_folder ? Path(named) : path_beside(named, "");
    if (is_folder && !folder.empty() && folder.view().back() != '/') folder.append("/");
    found.file = is_folder ? path_beside(folder.view(), kPackConfig) : Path(named);
    const Path manifest_path = path_beside(folder.view(), kPackManifest);
    if (found.file.cut() || manifest_path.cut())
        return refused(base::make_error(named, ": the path is too long; use a shorter one"));
    const auto manifest = look_at(manifest_path.c_str());
    if (!manifest.ok()) return refused(manifest.error());
    if (!is_folder && manifest.value() == Found::nothing) return found;
    const auto pack = check_pack(folder.empty() ? std::string_view("./") : folder.view(), public_key);
    if (!pack.ok()) return base::fail(pack.error());
    found.pack = pack.value();
    return found;
}

}  // namespace tedavis::platform
