#include "tests/layering/include_rule.hpp"

#include <algorithm>

namespace tedavis::tests::layering {
namespace {

using Names = std::vector<std::string>;

struct Folder {
    std::string path;  ///< of the files it speaks of; the longest match counts
    Names may_include;
};

const std::vector<Folder>& folders() {
    static const std::string core = "render_core/";
    static const Names base = {core + "base/"};
    static const auto with = [](Names names, std::initializer_list<const char*> more) {
        for (const char* name : more) names.emplace_back(name);
        return names;
    };
    static const Names earth = with(base, {"render_core/earth/"});
    static const Names flight = with(earth, {"render_core/flight/"});
    static const Names terrain_and_scene = with(flight, {"render_core/terrain/", "render_core/scene/"});
    static const std::vector<Folder> table = {
        {core + "base/", base},
        {core + "earth/", earth},
        {core + "flight/", flight},
        {core + "terrain/", with(flight, {"render_core/terrain/"})},
        {core + "scene/", with(flight, {"render_core/scene/"})},
        {core + "design/", with(terrain_and_scene, {"render_core/design/"})},
        {core + "perception/", with(terrain_and_scene, {"render_core/perception/"})},
        {core + "raytrace/", with(terrain_and_scene, {"render_core/raytrace/"})},
        {core + "effects/", with(terrain_and_scene, {"render_core/design/", "render_core/perception/", "render_core/raytrace/",
                                                     "render_core/effects/"})},
        {core + "policy/", with(terrain_and_scene, {"render_core/design/", "render_core/perception/", "render_core/raytrace/",
                                                    "render_core/effects/", "render_core/policy/"})},
        {core + "gl/", with(base, {"render_core/gl/", "render_core/effects/device"})},
        {core + "draw/",
         with(terrain_and_scene, {"render_core/design/", "render_core/perception/", "render_core/raytrace/",
                                  "render_core/effects/", "render_core/policy/", "render_core/gl/", "render_core/draw/"})},
        {core + "display/", {core}},
        {"bus/", with(flight, {"bus/"})},
        {"platform/", with(base, {"platform/"})},
        {"target/", {core, "bus/", "platform/", "target/"}},
        {"host_sim/", {core, "bus/", "platform/", "host_sim/"}},
        {"tests/", {core, "bus/", "platform/", "target/", "host_sim/", "tests/"}},
        {"toolchains/", {"toolchains/"}},
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
        {{"toml++/"}, {"render_core/base/config_reader.cpp"}},
        {{"glm/"}, {}},
        {{"immintrin.h"}, {"render_core/raytrace/lanes/"}},
        {{"assimp/", "gdal", "cpl_", "ogr_", "ogrsf_", "nlohmann/", "CLI/", "png.h", "zlib.h"}, {"host_sim/"}},
        {{"stb/"}, {"toolchains/"}},
        {{"csetjmp", "execinfo.h"}, {"host_sim/"}},
        {{"gtest/", "gmock/", "benchmark/", "GeographicLib/", "opencv2/", "embree3/"}, {"tests/"}},
        {{"linux/", "sys/", "net/", "unistd.h", "fcntl.h", "poll.h", "time.h", "signal.h", "errno.h"},
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

const Folder* folder_of(const std::string& path) {
    const Folder* best = nullptr;
    for (const Folder& folder : folders()) {
        if (starts_with(path, folder.path) && (best == nullptr || folder.path.size() > best->path.size())) best = &folder;
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
    if (own == nullptr) return "this folder is in no table of tests/layering/include_rule.cpp";
    if (folder_of(name) == nullptr) {
        const auto near = file.path.substr(0, file.path.rfind('/') + 1) + name;
        return known_paths.count(near) != 0 ? "\"" + name + "\" is not written from the root: \"" + near + "\""
                                            : "\"" + name + "\" is no header of this tree; system headers take <>";
    }
    if (!starts_with_any(name, own->may_include)) return "\"" + name + "\" may not be included by " + own->path;
    return {};
}

}  // namespace

std::vector<std::string> include_findings(const SourceFile& file, const std::set<std::string>& known_paths) {
    std::vector<std::string> findings;
    for (const IncludeLine& include : includes_of(file)) {
        const std::string sentence =
            include.angled ? judge_system_header(file, include.name) : judge_own_header(file, include.name, known_paths);
        if (!sentence.empty()) findings.push_back(finding(file, include.line, sentence));
    }
    return findings;
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
