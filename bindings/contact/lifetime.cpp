// SPDX-License-Identifier: LGPL-2.1-or-later
// The functions that begin and end the library and its result elements.
#include "bindings/contact/library.hpp"
#include "bindings/contact/rollfem/contact_addon.h"

#include <fmt/format.h>

namespace rollfem::addon {

namespace {

/// As CONTACT 25.1 counts.
constexpr int interface_version = 2501;

}  // namespace

extern "C" {

/// Files have no numbers here.
void cntc_setfileunits(const int*, const int*) {}

void cntc_initializefirst(int* ifcver, int* ierror, const int* ioutput, const char* wrkdir,
                          const char* outdir, const char* expnam, const int* len_wrkdir,
                          const int* len_outdir, const int* len_expnam) {
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

void cntc_initializefirst_new(int* ifcver, int* ierror, const int* ioutput, const char* wrkdir,
                              const char* outdir, const char* expnam, const int* len_wrkdir,
                              const int* len_outdir, const int* len_expnam) {
  cntc_initializefirst(ifcver, ierror, ioutput, wrkdir, outdir, expnam, len_wrkdir, len_outdir,
                       len_expnam);
}

void cntc_initialize(const int* ire, const int* imodul, int* ifcver, int* ierror,
                     const char* outdir, const int* len_outdir) {
  guarded("cntc_initialize", {ire, imodul, ifcver, outdir, len_outdir}, ierror, [&] {
    *ifcver = interface_version;
    if (*imodul != 1 && *imodul != 3)
      throw Refusal(err_other, fmt::format("module {}: allowed: 1, 3", *imodul));
    Library::here().begin(*ire, *imodul);
    return 0;
  });
}

void cntc_getmaxnumthreads(int* mxthrd) {
  guarded("cntc_getmaxnumthreads", {mxthrd}, nullptr, [&] {
    *mxthrd = 1024;  // there is no licence that limits them
    return 0;
  });
}

void cntc_finalize(const int* ire) {
  guarded("cntc_finalize", {ire}, nullptr, [&] {
    Library::here().end(*ire);
    return 0;
  });
}

void cntc_finalizelast(void) {
  guarded("cntc_finalizelast", {}, nullptr, [] {
    Library::here().end_all();
    return 0;
  });
}

}  // extern "C"

}  // namespace rollfem::addon
