/// Collects the design of a configuration and all files that it names. Each gets a path in the pack at which the unchanged names
/// in the other files still find it.
#pragma once

#include <map>
#include <string>

#include "host_sim/options/picture_options.hpp"
#include "host_sim/pack/packed_file.hpp"
#include "render_core/design/design_source.hpp"

namespace tedavis::host_sim {

/// Folders in a pack; each ends in a slash.
inline constexpr const char* kPackedDesign = "design/";
inline constexpr const char* kPackedDesigns = "designs/";
inline constexpr const char* kPackedPalettes = "palettes/";

class PackedDesigns final : public design::DesignSource {
public:
    /// `files` must outlive this object and receives what is read.
    PackedDesigns(const DesignFolders& folders, PackedFiles& files) : folders_(folders), files_(files) {}

    /// Reads the design and those that it names for phases, and returns the design's path in the pack. Throws UserError with file
    /// and line, also where a name cannot be kept in a pack, such as an absolute path.
    [[nodiscard]] std::string add(const std::string& design_file);

    [[nodiscard]] base::Result<design::Palette, base::Error> find(const base::StatedFile& palette) override;
    [[nodiscard]] base::Result<design::DesignText, base::Error> find_design(const base::StatedFile& design) override;

private:
    /// The path in the pack of a file that `stated` names; a short name lies in `folder` or, where that is empty, beside the file
    /// that names it.
    [[nodiscard]] std::string place_of(const base::StatedFile& stated, const std::string& folder) const;
    /// Returns its text.
    std::string take(const std::string& file, const std::string& place);

    DesignFolders folders_;
    PackedFiles& files_;
    std::map<std::string, std::string> places_;  ///< path in the pack by the file's own path
    std::string path_, text_;                    ///< of the design that find_design() returned last
};

}  // namespace tedavis::host_sim
