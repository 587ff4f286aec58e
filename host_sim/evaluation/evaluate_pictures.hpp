/// Measures single pictures and writes their views.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host_sim/evaluation/evaluation_files.hpp"
#include "host_sim/evaluation/evaluation_work.hpp"
#include "host_sim/evaluation/fixation_file.hpp"

namespace tedavis::host_sim {

struct EvaluatedPicture {
    std::string file;  ///< as the user named it
    std::string name;  ///< beginning of its view files' names
    PictureMeasures measures;
};

/// Returns each picture's file name without folders and extension; equal names get -2, -3 appended.
[[nodiscard]] std::vector<std::string> view_names(const std::vector<std::string>& files);

/// Replaces folders that `sheet` wrote by their pictures, in the sheet's order, and leaves out layer masks, which are beside
/// their pictures. Throws UserError where a sheet's record is damaged.
[[nodiscard]] std::vector<std::string> pictures_of_sheets(const std::vector<std::string>& inputs);

/// Returns the fixations of each picture, by the column `file`, which has its name as on the command line or without folders;
/// without this column all belong to the only picture. Throws UserError where the picture of a fixation is ambiguous.
[[nodiscard]] std::vector<std::vector<const Fixation*>> gaze_of_pictures(const FixationFile& file,
                                                                         const std::vector<std::string>& pictures);

/// Compares the pictures that have opinions.
[[nodiscard]] OpinionsAgreement agreement_over_pictures(const std::vector<EvaluatedPicture>& pictures);

/// Measures pictures and writes their views into the folder, which must exist. `gaze` may be null. If the work is stopped,
/// returns the pictures so far.
[[nodiscard]] std::vector<EvaluatedPicture> evaluate_pictures(const std::vector<std::string>& files, const std::string& folder,
                                                              const FixationFile* gaze, const EvaluationWork& work);

}  // namespace tedavis::host_sim
