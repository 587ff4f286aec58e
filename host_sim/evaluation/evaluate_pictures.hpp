/// Measures single pictures and leaves their views.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host_sim/evaluation/evaluation_files.hpp"
#include "host_sim/evaluation/evaluation_work.hpp"
#include "host_sim/evaluation/fixation_file.hpp"

namespace tedavis::host_sim {

struct EvaluatedPicture {
    std::string file;  ///< as it was named
    std::string name;  ///< beginning of its view files' names
    PictureMeasures measures;
};

/// Of each picture's file the name without folders and ending; where several are the same, with -2, -3 behind.
[[nodiscard]] std::vector<std::string> view_names(const std::vector<std::string>& files);

/// Folders that `sheet` wrote are replaced by their pictures, in the sheet's order; masks of layers, which lie beside their
/// pictures, are left out. Throws UserError where a sheet's record is damaged.
[[nodiscard]] std::vector<std::string> pictures_of_sheets(const std::vector<std::string>& inputs);

/// Fixations of each picture, by the column `file`, which names it as the command did or without folders; without it all belong
/// to the only picture. Throws UserError where several pictures cannot be told apart.
[[nodiscard]] std::vector<std::vector<const Fixation*>> gaze_of_pictures(const FixationFile& file,
                                                                         const std::vector<std::string>& pictures);

/// Of those that have opinions.
[[nodiscard]] OpinionsAgreement agreement_over_pictures(const std::vector<EvaluatedPicture>& pictures);

/// `gaze` may be null. Writes views into the folder, which is there. Where the work is stopped, returns the pictures so far.
[[nodiscard]] std::vector<EvaluatedPicture> evaluate_pictures(const std::vector<std::string>& files, const std::string& folder,
                                                              const FixationFile* gaze, const EvaluationWork& work);

}  // namespace tedavis::host_sim
