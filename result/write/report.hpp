// SPDX-License-Identifier: LGPL-2.1-or-later
// Runs the Python package: on a result folder, or for a whole command.
#pragma once

#include <string>
#include <vector>

namespace rollfem::result {

/// Runs the plotting program on output of rollfem: the folder of a run, a comparison, a study or a
/// table; stress.json; or the table NAME.csv of a profile or a wheelset, whose figure is NAME.svg.
/// Returns one line on failure, empty on success. Longer output of the program goes to report.log
/// in the folder. Results stay in any case. `script_directory` is the Python package
/// rollfem or the folder that holds it. Python is taken from the environment variable
/// ROLLFEM_PYTHON, else from the virtual environment that holds the package, else /usr/bin/python3,
/// else python3 on PATH; it imports no module from the current folder.
/// `overlays`: tables of measured creep curves, drawn over those of a run.
std::string make_report(const std::string& path, const std::string& script_directory,
                        const std::vector<std::string>& overlays = {});

/// Runs `python3 -m rollfem WORDS` in place of this program. Returns why, if that fails.
std::string become_package(const std::vector<std::string>& words,
                           const std::string& script_directory);

}  // namespace rollfem::result
