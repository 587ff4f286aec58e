#include "render_core/design/inherit_bases.hpp"

#include "render_core/base/fixed_vector.hpp"
#include "render_core/design/config_values.hpp"

namespace tedavis::design {
namespace {

static_assert(kMaxBases == 8, "as the sentence says");
constexpr const char* kTooMany = "is one base too many; at most 8 stand behind a design";
constexpr std::string_view kOwnKeys[] = {"name", "phases"};
constexpr std::string_view kSpacings[] = {"spacing_m", "spacing_nm", "spacing_arcmin"};
constexpr std::string_view kHeightSpacings[] = {"height_spacing_m", "height_spacing_ft"};
constexpr std::string_view kLineSpacings[] = {"line_spacing_m", "line_spacing_nm"};
constexpr base::KeyGroup kAlternatives[] = {kSpacings, kHeightSpacings, kLineSpacings};

/// The design itself and its bases.
using FileNames = base::FixedVector<base::FixedString<1023>, kMaxBases + 1>;

bool has(const FileNames& files, std::string_view file_name) {
    for (const base::FixedString<1023>& file : files)
        if (file.view() == file_name) return true;
    return false;
}

}  // namespace

void inherit_bases(base::ConfigReader& reader, DesignSource& files) {
    base::ConfigSection root = reader.root();
    FileNames read;
    static_cast<void>(read.try_push_back(reader.name()));
    while (root.has("based_on")) {
        const base::StatedFile stated = root.file("based_on");
        if (!reader.ok()) return;
        const auto found = files.find_design(stated);
        if (!found.ok()) return root.fault("based_on", found.error().message.view());
        const DesignText& base = found.value();
        if (has(read, base.file_name))
            return fault_of(root, "based_on", "names a design that is itself based on this one; name another, or leave it out");
        if (!read.try_push_back(base.file_name)) return fault_of(root, "based_on", kTooMany);
        root.remove("based_on");
        reader.inherit(base.text, base.file_name, kOwnKeys, kAlternatives);
    }
}

}  // namespace tedavis::design
