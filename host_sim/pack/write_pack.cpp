#include "host_sim/pack/write_pack.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

#include "host_sim/calendar_time.hpp"
#include "host_sim/options/toml_writer.hpp"
#include "host_sim/pack/sign_pack.hpp"
#include "host_sim/user_error.hpp"
#include "host_sim/version.hpp"
#include "platform/configuration/pack_check.hpp"
#include "platform/configuration/sha256.hpp"

namespace tedavis::host_sim {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kCopiedBytes = 1 << 20;

/// Beside the place of the pack; removed unless it was put there.
class PackPart {
public:
    explicit PackPart(const std::string& place) {
        std::string pattern = place + ".part.XXXXXX";
        if (mkdtemp(pattern.data()) == nullptr)
            throw UserError(place + ": no folder can be made beside it (" + std::strerror(errno) + "); name another place");
        path_ = pattern;
    }
    ~PackPart() {
        std::error_code ignored;
        if (!path_.empty()) fs::remove_all(path_, ignored);
    }
    PackPart(const PackPart&) = delete;
    PackPart& operator=(const PackPart&) = delete;

    [[nodiscard]] const std::string& path() const { return path_; }
    void keep() { path_.clear(); }

private:
    std::string path_;
};

/// A file or folder whose changes are brought to the medium.
class SyncedPath {
public:
    explicit SyncedPath(const std::string& path) : path_(path), descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
        if (descriptor_ < 0) refuse();
    }
    ~SyncedPath() { ::close(descriptor_); }
    SyncedPath(const SyncedPath&) = delete;
    SyncedPath& operator=(const SyncedPath&) = delete;

    void sync() const {
        if (::fsync(descriptor_) != 0) refuse();
    }

private:
    [[noreturn]] void refuse() const {
        throw UserError(path_ + ": cannot be brought to the medium (" + std::strerror(errno) + "); check it");
    }

    std::string path_;
    int descriptor_;
};

/// A board's display runs as a user of its own, so all may read a pack, whatever the umask is.
void finish_path(const std::string& path, bool is_folder) {
    chmod(path.c_str(), is_folder ? 0755 : 0644);
    SyncedPath(path).sync();
}

void finish_folders(const std::string& root) {
    for (const auto& entry : fs::recursive_directory_iterator(root))
        if (entry.is_directory()) finish_path(entry.path().string(), true);
    finish_path(root, true);
}

struct Written {
    std::uint64_t bytes = 0;
    std::string sha256;
};

class PackWriter {
public:
    PackWriter(const PackContents& contents, const PackSettings& settings, const PackProgress& progress)
        : contents_(contents), settings_(settings), progress_(progress) {}

    void write(const std::string& root) {
        for (const PackedFile& file : contents_.files) total_ += file_bytes(file.from);
        for (const PackedFile& file : contents_.files) put_entry(file, copy(file, root + "/" + file.path));
        const std::string config = root + "/" + platform::kPackConfig;
        put_entry({contents_.config_origin, platform::kPackConfig, {}, {}, {}}, put_text(config, contents_.config_text));
        const std::string manifest = root + "/" + platform::kPackManifest;
        static_cast<void>(put_text(manifest, head() + entries_.text()));
        if (!settings_.secret_key.empty()) {
            sign_with_minisign(manifest, settings_.secret_key);
            finish_path(manifest + ".minisig", false);
        }
        finish_folders(root);
    }

private:
    static std::uint64_t file_bytes(const std::string& path) {
        std::error_code error;
        const std::uintmax_t bytes = fs::file_size(path, error);
        if (error) throw UserError(path + ": cannot be read (" + error.message() + "); check the path");
        return bytes;
    }

    [[nodiscard]] std::string head() const {
        TomlWriter toml;
        toml.word("title", contents_.title);
        toml.word("made", utc_now());
        toml.word("made_by", std::string("tedavis ") + version() + " (" + commit() + ")");
        toml.word("valid_from", settings_.valid_from);
        toml.word("valid_until", settings_.valid_until);
        return toml.text();
    }

    void put_entry(const PackedFile& file, const Written& written) {
        entries_.list_entry("file");
        entries_.word("path", file.path);
        entries_.integer("bytes", written.bytes);
        entries_.word("sha256", written.sha256);
        entries_.word("origin", fs::absolute(file.from).lexically_normal().string());
        entries_.word("sources", file.sources);
        entries_.word("valid_from", file.valid_from);
        entries_.word("valid_until", file.valid_until);
    }

    Written copy(const PackedFile& file, const std::string& to) {
        fs::create_directories(fs::path(to).parent_path());
        std::ifstream in(file.from, std::ios::binary);
        std::ofstream out(to, std::ios::binary);
        std::vector<char> block(kCopiedBytes);
        platform::Sha256 sha;
        Written written;
        while (in.read(block.data(), static_cast<std::streamsize>(block.size())), in.gcount() > 0) {
            out.write(block.data(), in.gcount());
            sha.add(block.data(), static_cast<std::size_t>(in.gcount()));
            written.bytes += static_cast<std::uint64_t>(in.gcount());
            progress_(done_ += static_cast<std::uint64_t>(in.gcount()), total_);
        }
        if (in.bad() || !in.eof()) throw UserError(file.from + ": cannot be read to its end; check the medium");
        finish(out, to);
        written.sha256 = platform::hex_of(sha.digest()).view();
        return written;
    }

    static Written put_text(const std::string& to, const std::string& text) {
        std::ofstream out(to, std::ios::binary);
        out << text;
        finish(out, to);
        platform::Sha256 sha;
        sha.add(text.data(), text.size());
        return {text.size(), std::string(platform::hex_of(sha.digest()).view())};
    }

    static void finish(std::ofstream& out, const std::string& path) {
        out.close();
        if (!out) throw UserError(path + ": could not be written to its end; check the free space");
        finish_path(path, false);
    }

    const PackContents& contents_;
    const PackSettings& settings_;
    const PackProgress& progress_;
    std::uint64_t done_ = 0, total_ = 0;
    TomlWriter entries_;
};

/// Without the last slash.
std::string place_of_pack(const std::string& folder) {
    fs::path place = fs::absolute(folder).lexically_normal();
    if (!place.has_filename()) place = place.parent_path();
    return place.string();
}

/// A pack that is replaced is removed, so all that lies in it must be a pack's.
void require_listed_pack(const std::string& place) {
    const auto listed = platform::list_pack(place);
    if (!listed.ok())
        throw UserError(place + ": is not replaced, for it is no sound pack (" + std::string(listed.error().message.view()) +
                        "); name another folder");
}

/// Returns whether an earlier pack is there, which is to be replaced.
bool require_place(const std::string& place, bool replaces) {
    std::error_code ignored;
    if (!fs::exists(fs::symlink_status(place, ignored))) {
        if (!fs::is_directory(fs::path(place).parent_path(), ignored))
            throw UserError(place + ": the folder that it lies in is not there; make it first");
        return false;
    }
    if (!fs::is_directory(fs::symlink_status(place, ignored)) ||
        !fs::is_regular_file(place + "/" + platform::kPackManifest, ignored))
        throw UserError(place + ": is there and no pack; name another folder");
    if (!replaces) throw UserError(place + ": is a pack already; name another folder, or replace it with --replace");
    require_listed_pack(place);
    return true;
}

[[noreturn]] void refuse_rename(const std::string& place, bool replaces, int reason) {
    if (!replaces && reason == EEXIST)
        throw UserError(place + ": somebody made it while the pack was written; name another folder");
    throw UserError(place + ": cannot be put in its place in one step (" + std::strerror(reason) + "); use another file system" +
                    (replaces ? ", or remove the earlier pack first" : ""));
}

/// In one step: whoever opens the place sees the earlier pack or the new one, whole. `replaces` as require_place() found it.
void put_in_place(PackPart& part, const std::string& place, bool replaces) {
    if (replaces) require_listed_pack(place);  // it may have been written into while the files were copied
    const SyncedPath around(fs::path(place).parent_path().string());
    const unsigned flag = replaces ? RENAME_EXCHANGE : RENAME_NOREPLACE;
    if (renameat2(AT_FDCWD, part.path().c_str(), AT_FDCWD, place.c_str(), flag) != 0) refuse_rename(place, replaces, errno);
    try {
        around.sync();
    } catch (const UserError&) {
        static_cast<void>(renameat2(AT_FDCWD, place.c_str(), AT_FDCWD, part.path().c_str(), flag));
        throw;
    }
    if (!replaces) part.keep();  // else it holds the earlier pack, which goes
}

}  // namespace

platform::CheckedPack write_pack(const PackContents& contents, const PackSettings& settings, const PackProgress& progress) {
    const std::string place = place_of_pack(settings.folder);
    const bool replaces = require_place(place, settings.replaces);
    PackPart part(place);
    PackWriter(contents, settings, progress).write(part.path());
    auto checked = platform::check_pack(part.path(), nullptr);
    if (!checked.ok()) throw UserError(std::string(checked.error().message.view()));
    put_in_place(part, place, replaces);
    checked.value().folder = platform::Path(place + "/");
    return checked.value();
}

}  // namespace tedavis::host_sim
