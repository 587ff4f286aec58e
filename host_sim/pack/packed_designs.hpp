/// The design of a configuration with all that it names, each at a place in a pack where the names that stand in the files still
/// find it: the files themselves are not changed.
#pragma once

#include <map>
#include <string>

#include "host_sim/options/picture_options.hpp"
#include "host_sim/pack/packed_file.hpp"
#include "render_core/design/design_source.hpp"

namespace tedavis::host_sim {

/// Places in a pack. Each ends in a slash.
inline constexpr const char* kPackedDesign = "design/";
inline constexpr const char* kPackedDesigns = "designs/";
inline constexpr const char* kPackedPalettes = "palettes/";

class PackedDesigns final : public design::DesignSource {
public:
    /// `files` must outlive this object and receives what is read.
    PackedDesigns(const DesignFolders& folders, PackedFiles& files) : folders_(folders), files_(files) {}

    /// Reads the design and those that it names for phases, and returns the design's path in the pack. Throws UserError with
    /// file and line, also where a file is named in a way that no pack can keep.
    [[nodiscard]] std::string add(const std::string& design_file);

    [[nodiscard]] base::Result<design::Palette, base::Error> find(const base::StatedFile& palette) override;
    [[nodiscard]] base::Result<design::DesignText, base::Error> find_design(const base::StatedFile& design) override;

private:
    /// Where a file lies that `stated_in` names; a short name in `folder`, or where that is empty beside.
    [[nodiscard]] std::string place_of(const base::StatedFile& stated, const std::string& folder) const;
    /// Returns its text.
    std::string take(const std::string& file, const std::string& place);

    DesignFolders folders_;
    PackedFiles& files_;
    std::map<std::string, std::string> places_;  ///< of files that were read
    std::string path_, text_;                    ///< of the design that was found last
};

}  // namespace tedavis::host_sim
