// SPDX-License-Identifier: LGPL-2.1-or-later
// rollfem from C++, in one header: read or parse a case, solve it with any model, inspect the
// results or write them as the program does. Units, signs and frames are those of case files and
// results (docs/c_interface.md). Only this header and its includes are installed and stay
// compatible within a minor version; everything else may change with every commit.
#pragma once

#include "base/errors.hpp"
#include "base/progress.hpp"
#include "case/case.hpp"
#include "result/quantities.hpp"
#include "result/result.hpp"
#include "result/write/output.hpp"

#include <string>
#include <vector>

namespace rollfem {

using contact::Case;
using contact::FileError;
using contact::InputError;
using contact::ModelResult;
using contact::PointResult;
using contact::Progress;
using contact::ProgressEvent;
using contact::SolveError;

/// A case with its results, one ModelResult for each model and patch.
using Result = result::RunRecord;

/// A model without a result for a case, and why.
using Missing = result::MissingModel;

/// Reads a case file. Throws InputError with FILE:LINE:COLUMN, key, value, allowed values and
/// advice. `changes`: of single keys, as for `--set`: "fem.cell_size=0.5".
Case read_case(const std::string& file, const std::vector<std::string>& changes = {});

/// Parses a case from text. `name` represents the file in messages; paths in the case are relative
/// to its folder.
Case parse_case(const std::string& text, const std::string& name = "case");

/// Multi-line text with every key, its value and unit, and whether it is the default.
std::string describe(const Case& input);

/// Names of the models that this build has, the cheaper first.
std::vector<std::string> models();

/// Solves a case with the models named, or else with its own. `progress` (may be empty) is told of
/// every iteration; what it throws ends the solution and comes out of here. May be called from
/// several threads at once; finite elements then wait for each other. Throws InputError and
/// SolveError. An accuracy that was asked for and not reached is no error here: it is said in
/// ModelResult::shortfall. With `missing` models that cannot take the case, or fail, are listed
/// there, and the others go on.
Result solve(const Case& input, const std::vector<std::string>& models = {},
             const Progress& progress = {}, std::vector<Missing>* missing = nullptr);

/// The same for case files.
Result solve_file(const std::string& file, const std::vector<std::string>& models = {},
                  const Progress& progress = {});

/// Writes the same folder as `rollfem run`, completely or not at all. With `report` also figures
/// and report.html, which take some seconds. Returns why these could not be drawn, or an empty
/// text. Throws InputError if the folder cannot be written.
std::string write(const std::string& folder, const Result& result, bool report = false);

/// Folder of the Python package rollfem, which draws reports and reads results.
std::string figures_directory();

/// "0.1.0"
std::string version();

}  // namespace rollfem
