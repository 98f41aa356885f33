// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bindings/contact/library.hpp"

#include "base/errors.hpp"
#include "bindings/contact/rollfem/contact_addon.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <filesystem>

namespace rollfem::addon {

namespace fs = std::filesystem;

Library& Library::here() {
  static Library library;
  return library;
}

void Library::open(const std::string& work_folder, const std::string& log_folder, int ioutput) {
  const std::lock_guard<std::mutex> lock(mutex_);
  work_folder_ = work_folder;
  log_folder_ = log_folder;
  screen_ = ioutput == 1;
}

void Library::set_flag(int code, int value) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (code == if_idebug) debug_ = value;
  if (code == if_openmp) threads_ = std::clamp(value, value < 0 ? 0 : 1, 64);
}

std::shared_ptr<Element> Library::begin(int ire, int module) {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::shared_ptr<Element>& element = elements_[ire];
  if (!element || element->module != module) {
    element = std::make_shared<Element>();
    element->module = module;
    element->as_set_for_all.given.module = module;
  }
  return element;
}

std::shared_ptr<Element> Library::find(int ire) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = elements_.find(ire);
  return found == elements_.end() ? nullptr : found->second;
}

std::shared_ptr<Element> Library::at(int ire) const {
  std::shared_ptr<Element> element = find(ire);
  if (!element) throw Refusal(err_icp, "there is no such result element");
  return element;
}

void Library::end(int ire) {
  bool last = false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (elements_.erase(ire) == 0) throw Refusal(err_icp, "there is no such result element");
    last = elements_.empty();
  }
  if (last) end_all();
}

void Library::end_all() {
  const std::lock_guard<std::mutex> lock(mutex_);
  elements_.clear();
  log_.reset();
  debug_ = threads_ = 1;
}

void Library::log(const std::string& line) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (debug_ <= 0) return;
  if (!log_)
    log_.reset(std::fopen((fs::path(log_folder_) / "contact_addon.out").c_str(),
                          std::exchange(logged_, true) ? "a" : "w"));
  if (log_) {
    std::fprintf(log_.get(), "%s\n", line.c_str());
    std::fflush(log_.get());
  }
  if (screen_) std::fprintf(stdout, "%s\n", line.c_str());
}

std::string Library::path_of(const std::string& name) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return fs::absolute(fs::path(work_folder_) / name).string();
}

namespace {

int code_of(const std::exception& error) {
  if (const auto* refusal = dynamic_cast<const Refusal*>(&error)) return refusal->code();
  return dynamic_cast<const contact::SolveError*>(&error) != nullptr ? err_norm : err_other;
}

/// Under which a problem is kept: module 1 has one.
int key_of(const Element& element, int icp) {
  return element.module == 1 ? 0 : icp;
}

/// A text before errors of this problem.
template <class Work>
void at_problem(int ire, int icp, const Work& work) {
  try {
    work();
  } catch (const std::exception& error) {
    throw Refusal(code_of(error),
                  fmt::format("result element {}, contact problem {}: {}", ire, icp, error.what()));
  }
}

}  // namespace

void guarded(const char* function, std::initializer_list<const void*> arguments, int* ierror,
             const std::function<int()>& work) {
  int code = err_other;
  std::string why;
  try {
    if (std::find(arguments.begin(), arguments.end(), nullptr) != arguments.end())
      throw Refusal(err_other, "an argument is null");
    code = work();
  } catch (const std::exception& error) {
    code = code_of(error);
    why = error.what();
  } catch (...) {
    why = "an unknown error";
  }
  if (ierror != nullptr) *ierror = code;
  if (why.empty()) return;
  try {
    Library::here().log(fmt::format("{}: error {}: {}", function, code, why));
  } catch (const std::exception&) {  // without a log the code still tells
  }
}

void guarded(const char* function, std::initializer_list<const void*> arguments,
             const std::function<void()>& work) {
  guarded(function, arguments, nullptr, [&] {
    work();
    return 0;
  });
}

void for_problems(int ire, int icp, const std::function<void(Problem&)>& work) {
  std::shared_ptr<Element> element = Library::here().find(ire);
  if (!element) element = Library::here().begin(ire, 3);
  const std::lock_guard<std::mutex> lock(element->mutex);
  at_problem(ire, icp, [&] {
    const bool all = element->module == 3 && icp <= 0;
    if (all) {
      work(element->as_set_for_all);
      for (auto& [number, problem] : element->problems) work(problem);
      return;
    }
    work(element->problems.try_emplace(key_of(*element, icp), element->as_set_for_all)
             .first->second);
  });
}

void for_pair(int ire, const std::function<void(Problem&)>& work) {
  if (Library::here().at(ire)->module != 1)
    throw Refusal(err_icp,
                  fmt::format("result element {}: this is a setting of module 1 alone", ire));
  for_problems(ire, -1, work);
}

void for_problem(int ire, int icp, const std::function<void(Problem&)>& work) {
  const std::shared_ptr<Element> element = Library::here().at(ire);
  const std::lock_guard<std::mutex> lock(element->mutex);
  at_problem(ire, icp, [&] {
    const auto found = element->problems.find(key_of(*element, icp));
    if (found == element->problems.end())
      throw Refusal(err_icp, "there is no such contact problem");
    work(found->second);
  });
}

void for_patch(int ire, int icp, const std::function<void(Problem&, const Patch&)>& work) {
  for_problem(ire, icp, [&](Problem& problem) {
    const std::vector<Patch*> patches = patches_of(problem, icp);
    if (patches.empty()) throw Refusal(err_icp, "there is no such patch");
    work(problem, *patches.front());
  });
}

std::string text_of(const char* text, int length) {
  constexpr int longest = 4096;
  if (length < 0 || length > longest) throw Refusal(err_other, "a text of impossible length");
  std::string value(text, std::find(text, text + length, '\0'));
  const auto first = value.find_first_not_of(" \t");
  if (first == std::string::npos) return {};
  return value.substr(first, value.find_last_not_of(" \t") - first + 1);
}

void demand_arrays(Int nints, Int iparam, Int nreals, Real rparam) {
  if ((*nints > 0 && iparam == nullptr) || (*nreals > 0 && rparam == nullptr))
    throw Refusal(err_other, "an argument is null");
}

// The functions that begin and end the library and its result elements.

/// As CONTACT 25.1 counts.
static constexpr int interface_version = 2501;

extern "C" {

/// Files have no numbers here.
void cntc_setfileunits(const int*, const int*) {}

void cntc_initializefirst(int* ifcver, int* ierror, Int ioutput, const char* wrkdir,
                          const char* outdir, const char* expnam, Int len_wrkdir, Int len_outdir,
                          Int len_expnam) {
  guarded("cntc_initializefirst",
          {ifcver, ioutput, wrkdir, outdir, expnam, len_wrkdir, len_outdir, len_expnam}, ierror,
          [&] {
            *ifcver = interface_version;
            const std::string work = text_of(wrkdir, *len_wrkdir);
            const std::string out = text_of(outdir, *len_outdir);
            Library::here().open(work, out.empty() ? work : out, *ioutput);
            return 0;
          });
}

void cntc_initializefirst_new(int* ifcver, int* ierror, Int ioutput, const char* wrkdir,
                              const char* outdir, const char* expnam, Int len_wrkdir,
                              Int len_outdir, Int len_expnam) {
  cntc_initializefirst(ifcver, ierror, ioutput, wrkdir, outdir, expnam, len_wrkdir, len_outdir,
                       len_expnam);
}

void cntc_initialize(Int ire, Int imodul, int* ifcver, int* ierror, const char* outdir,
                     Int len_outdir) {
  guarded("cntc_initialize", {ire, imodul, ifcver, outdir, len_outdir}, ierror, [&] {
    *ifcver = interface_version;
    if (*imodul != 1 && *imodul != 3)
      throw Refusal(err_other, fmt::format("module {}: allowed: 1, 3", *imodul));
    Library::here().begin(*ire, *imodul);
    return 0;
  });
}

void cntc_getmaxnumthreads(int* mxthrd) {
  guarded("cntc_getmaxnumthreads", {mxthrd}, [&] {
    *mxthrd = 1024;  // there is no licence that limits them
  });
}

void cntc_finalize(Int ire) {
  guarded("cntc_finalize", {ire}, [&] { Library::here().end(*ire); });
}

void cntc_finalizelast(void) {
  guarded("cntc_finalizelast", {}, [] { Library::here().end_all(); });
}

}  // extern "C"

}  // namespace rollfem::addon
