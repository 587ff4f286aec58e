#include "tests/layering/include_rule.hpp"

#include <algorithm>

namespace tedavis::tests::layering {
namespace {

using Names = std::vector<std::string>;

struct Folder {
    std::string path;
    bool is_flat;       ///< only files that lie in the folder itself are meant; else all below it
    Names may_include;  ///< folders of the table
    Names headers;      ///< beginnings of paths that may be included, too
};

// Written by CMake: toolchains/declare_module.cmake.
const std::vector<Folder>& folders() {
    static const std::vector<Folder> table = {
#include "tests/layering/include_table.inc"
    };
    return table;
}

struct SystemHeaders {
    Names headers;     ///< whole names, folders and families, as names_header() reads them
    Names allowed_in;  ///< beginnings of paths; empty: everywhere
};

// The first match counts. Tests may use every header.
const std::vector<SystemHeaders>& system_headers() {
    static const std::vector<SystemHeaders> table = {
        {{"linux/can"}, {"bus/socketcan/"}},
        {{"gpiod.h"}, {"bus/switches/gpiod_"}},
        {{"GLES2/", "GLES3/", "KHR/"}, {"render_core/gl/"}},
        {{"GL/osmesa.h"}, {"platform/osmesa/"}},
        {{"EGL/", "SDL"}, {"platform/"}},
        {{"gbm.h", "xf86drm", "drm"}, {"platform/"}},
        {{"libseat.h"}, {"platform/egl_kms/seat_port"}},
        {{"sodium.h"}, {"platform/configuration/"}},
        {{"toml++/"}, {"render_core/base/config_reader.cpp", "host_sim/flight_test/script_value.cpp"}},
        {{"glm/"}, {}},
        {{"immintrin.h"}, {"render_core/raytrace/lanes/"}},
        {{"assimp/", "gdal", "cpl_", "ogr_", "ogrsf_", "nlohmann/", "CLI/", "png.h", "zlib.h"}, {"host_sim/"}},
        {{"libavcodec/", "libavformat/", "libavutil/", "libswscale/"}, {"host_sim/replay/video_file.cpp"}},
        {{"stb/"}, {"toolchains/"}},
        {{"csetjmp", "execinfo.h", "spawn.h"}, {"host_sim/"}},
        {{"GeographicLib/"}, {"target/self_test/geodesy_check.cpp", "tests/"}},
        {{"gtest/", "gmock/", "benchmark/", "opencv2/", "embree3/"}, {"tests/"}},
        {{"linux/", "sys/", "net/", "unistd.h", "fcntl.h", "poll.h", "time.h", "signal.h", "errno.h", "grp.h"},
         {"bus/socketcan/", "bus/switches/gpiod_", "platform/", "target/", "host_sim/"}},
        {{"dlfcn.h", "pthread.h", "sched.h", "semaphore.h", "dirent.h"}, {"platform/", "target/", "host_sim/"}},
        {{"chrono", "thread", "mutex", "shared_mutex", "condition_variable", "future"}, {"platform/", "target/", "host_sim/"}},
        {{"exception",    "stdexcept", "typeinfo", "typeindex", "any",       "system_error",  "filesystem",    "fstream",
          "iostream",     "istream",   "ostream",  "sstream",   "streambuf", "iomanip",       "iosfwd",        "ios",
          "locale",       "random",    "regex",    "map",       "set",       "unordered_map", "unordered_set", "list",
          "forward_list", "deque",     "queue",    "stack",     "functional"},
         {"host_sim/", "toolchains/", "render_core/base/config_reader.cpp"}},
    };
    return table;
}

const std::set<std::string>& plain_headers() {
    static const std::set<std::string> names = {
        "algorithm", "array",       "atomic",    "bitset",  "cassert",  "cctype",  "cerrno",           "cfenv",
        "cfloat",    "charconv",    "cinttypes", "climits", "cmath",    "complex", "csignal",          "cstdarg",
        "cstddef",   "cstdint",     "cstdio",    "cstdlib", "cstring",  "ctime",   "initializer_list", "iterator",
        "limits",    "memory",      "new",       "numeric", "optional", "ratio",   "string",           "string_view",
        "tuple",     "type_traits", "utility",   "variant", "vector"};
    return names;
}

bool starts_with_any(const std::string& text, const Names& beginnings) {
    return std::any_of(beginnings.begin(), beginnings.end(), [&](const std::string& b) { return starts_with(text, b); });
}

// A name is a whole header, a folder of headers, or the beginning of a family.
bool names_header(const std::string& header, const std::string& name) {
    const bool family = name.back() == '/' || name.back() == '_' || name == "SDL" || name == "gdal" || name == "linux/can" ||
                        name == "xf86drm" || name == "drm";
    return family ? starts_with(header, name) : header == name;
}

bool holds(const Folder& folder, const std::string& path) {
    if (folder.path == path) return true;
    return starts_with(path, folder.path + "/") &&
           (!folder.is_flat || path.find('/', folder.path.size() + 1) == std::string::npos);
}

// The longest match counts.
const Folder* folder_of(const std::string& path) {
    const Folder* best = nullptr;
    for (const Folder& folder : folders()) {
        if (holds(folder, path) && (best == nullptr || folder.path.size() > best->path.size())) best = &folder;
    }
    return best;
}

std::string judge_system_header(const SourceFile& file, const std::string& name) {
    if (starts_with(file.path, "tests/") || plain_headers().count(name) != 0) return {};
    for (const SystemHeaders& rule : system_headers()) {
        const bool matches =
            std::any_of(rule.headers.begin(), rule.headers.end(), [&](const std::string& h) { return names_header(name, h); });
        if (!matches) continue;
        if (rule.allowed_in.empty() || starts_with_any(file.path, rule.allowed_in)) return {};
        std::string where;
        for (const std::string& place : rule.allowed_in) where += (where.empty() ? "" : ", ") + place;
        return "<" + name + "> may be included only below " + where;
    }
    return "<" + name + "> is in no table; add it to tests/layering/include_rule.cpp with the folders that may include it";
}

std::string judge_own_header(const SourceFile& file, const std::string& name, const std::set<std::string>& known_paths) {
    const Folder* own = folder_of(file.path);
    if (own == nullptr) return "no CMakeLists.txt declares this folder; name it there (toolchains/declare_module.cmake)";
    const Folder* theirs = folder_of(name);
    if (theirs == nullptr) {
        if (known_paths.count(name) != 0) return "no CMakeLists.txt declares the folder of \"" + name + "\"; name it there";
        const auto near = file.path.substr(0, file.path.rfind('/') + 1) + name;
        return known_paths.count(near) != 0 ? "\"" + name + "\" is not written from the root: \"" + near + "\""
                                            : "\"" + name + "\" is no header of this tree; system headers take <>";
    }
    const bool is_allowed = std::find(own->may_include.begin(), own->may_include.end(), theirs->path) != own->may_include.end() ||
                            starts_with_any(name, own->headers);
    return is_allowed ? std::string() : "\"" + name + "\" may not be included by " + own->path;
}

}  // namespace

std::vector<std::string> include_findings(const SourceFile& file, const std::set<std::string>& known_paths) {
    std::vector<std::string> findings;
    for (const IncludeLine& include : includes_of(file)) {
        const std::string message =
            include.angled ? judge_system_header(file, include.name) : judge_own_header(file, include.name, known_paths);
        if (!message.empty()) findings.push_back(finding(file, include.line, message));
    }
    return findings;
}

std::vector<std::string> folders_below(const std::string& root) {
    std::vector<std::string> names;
    for (const Folder& folder : folders()) {
        if (starts_with(folder.path, root + "/")) names.push_back(folder.path.substr(root.size() + 1));
    }
    return names;
}

std::vector<std::string> own_header_findings(const SourceFile& file, const std::set<std::string>& known_paths) {
    const std::string stem = file.path.substr(0, file.path.rfind('.'));
    if (stem + ".hpp" == file.path) {
        if (file.text.find("\n#pragma once\n") != std::string::npos || starts_with(file.text, "#pragma once\n")) return {};
        return {finding(file, 1, "a header needs #pragma once")};
    }
    if (known_paths.count(stem + ".hpp") == 0) return {};
    const std::vector<IncludeLine> includes = includes_of(file);
    if (!includes.empty() && includes.front().name == stem + ".hpp") return {};
    return {finding(file, includes.empty() ? 1 : includes.front().line, "\"" + stem + ".hpp\" must be its first include")};
}

}  // namespace tedavis::tests::layering
