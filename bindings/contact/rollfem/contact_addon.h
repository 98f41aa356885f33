/* SPDX-License-Identifier: LGPL-2.1-or-later
 * The functions of CONTACT's library (E. A. H. Vollebregt, Vtech CMCC) as rollfem has them:
 * docs/contact_library.md. All arguments are by reference; texts have a length and need no 0 at
 * their end; arrays are as in Fortran. ire: result element, icp: contact problem or patch. */
#ifndef ROLLFEM_CONTACT_ADDON_H
#define ROLLFEM_CONTACT_ADDON_H

#ifdef __cplusplus
extern "C" {
#endif

void cntc_setfileunits(const int* nunits, const int* iunits);
void cntc_initializefirst(int* ifcver, int* ierror, const int* ioutput, const char* wrkdir, const char* outdir, const char* expnam, const int* len_wrkdir, const int* len_outdir, const int* len_expnam);
void cntc_initializefirst_new(int* ifcver, int* ierror, const int* ioutput, const char* wrkdir, const char* outdir, const char* expnam, const int* len_wrkdir, const int* len_outdir, const int* len_expnam);
void cntc_initialize(const int* ire, const int* imodul, int* ifcver, int* ierror, const char* outdir, const int* len_outdir);
void cntc_setglobalflags(const int* lenflg, const int* params, const int* values);
void cntc_getmaxnumthreads(int* mxthrd);
void cntc_readinpfile(const int* ire, const int* inp_type, const char* fname, const int* len_fname, int* ierror);
void cntc_setflags(const int* ire, const int* icp, const int* lenflg, const int* params, const int* values);
void cntc_setmetadata(const int* ire, const int* icp, const int* lenmta, const int* params, const double* values);
void cntc_setsolverflags(const int* ire, const int* icp, const int* gdigit, const int* nints, const int* iparam, const int* nreals, const double* rparam);
void cntc_setmaterialparameters(const int* ire, const int* icp, const int* imeth, const int* nparam, const double* rparam);
void cntc_settemperaturedata(const int* ire, const int* icp, const int* imeth, const int* nparam, const double* params);
void cntc_settimestep(const int* ire, const int* icp, const double* dt);
void cntc_setreferencevelocity(const int* ire, const int* icp, const double* veloc);
void cntc_setrollingstepsize(const int* ire, const int* icp, const double* chi, const double* dq);
void cntc_setfrictionmethod(const int* ire, const int* icp, const int* imeth, const int* nparam, const double* params);
void cntc_sethertzcontact(const int* ire, const int* icp, const int* ipotcn, const int* nparam, const double* params);
void cntc_setpotcontact(const int* ire, const int* icp, const int* ipotcn, const int* nparam, const double* params);
void cntc_setverticalforce(const int* ire, const double* fz);
void cntc_setpenetration(const int* ire, const int* icp, const double* pen);
void cntc_setnormalforce(const int* ire, const int* icp, const double* fn);
void cntc_setundeformeddistc(const int* ire, const int* icp, const int* ibase, const int* nparam, const double* prmudf);
void cntc_setcreepages(const int* ire, const int* icp, const double* vx, const double* vy, const double* phi);
void cntc_setextrarigidslip(const int* ire, const int* icp, const int* lenarr, const double* wx, const double* wy);
void cntc_settangentialforces(const int* ire, const int* icp, const double* fx, const double* fy);
void cntc_setprofileinputfname(const int* ire, const char* fname, const int* len_fname, const int* nints, const int* iparam, const int* nreals, const double* rparam);
void cntc_setprofileinputvalues(const int* ire, const int* npoint, const double* values, const int* nints, const int* iparam, const int* nreals, const double* rparam);
void cntc_settrackdimensions(const int* ire, const int* ztrack, const int* nparam, const double* params);
void cntc_setwheelsetdimensions(const int* ire, const int* ewheel, const int* nparam, const double* params);
void cntc_setwheelsetposition(const int* ire, const int* ewheel, const int* nparam, const double* params);
void cntc_setwheelsetvelocity(const int* ire, const int* ewheel, const int* nparam, const double* params);
void cntc_setwheelsetflexibility(const int* ire, const int* ewheel, const int* nparam, const double* params);
void subs_addblock(const int* ire, const int* icp, const int* iblk, const int* isubs, const int* npx, const int* npy, const int* npz, const double* xparam, const double* yparam, const double* zparam);
void cntc_calculate(const int* ire, const int* icp, int* ierror);
void subs_calculate(const int* ire, const int* icp, int* ierror);
void cntc_getflags(const int* ire, const int* icp, const int* lenflg, const int* params, int* values);
void cntc_getparameters(const int* ire, const int* icp, const int* itask, const int* lenarr, double* values);
void cntc_getprofilevalues(const int* ire, const int* itask, const int* nints, const int* iparam, const int* nreals, const double* rparam, const int* lenarr, double* val);
void cntc_getprofilevalues_new(const int* ire, const int* itask, const int* nints, const int* iparam, const int* nreals, const double* rparam, const int* lenarr, double* val);
void cntc_getwheelsetposition(const int* ire, const int* lenarr, double* rvalues);
void cntc_getwheelsetvelocity(const int* ire, const int* lenarr, double* rvalues);
void cntc_getnumcontactpatches(const int* ire, int* npatch);
void cntc_getcontactlocation(const int* ire, const int* icp, const int* lenarr, double* rvalues);
void cntc_getreferencevelocity(const int* ire, const int* icp, double* veloc);
void cntc_gethertzcontact(const int* ire, const int* icp, const int* lenarr, double* rvalues);
void cntc_getnumelements(const int* ire, const int* icp, int* mx, int* my);
void cntc_getgriddiscretization(const int* ire, const int* icp, double* dx, double* dy);
void cntc_getpotcontact(const int* ire, const int* icp, const int* lenarr, double* rvalues);
void cntc_getpenetration(const int* ire, const int* icp, double* pen);
void cntc_getcreepages(const int* ire, const int* icp, double* vx, double* vy, double* phi);
void cntc_getcontactforces(const int* ire, const int* icp, double* fn, double* tx, double* ty, double* mz);
void cntc_getglobalforces(const int* ire, const int* icp, const int* lenarr, double* rvalues);
void cntc_getcontactpatchareas(const int* ire, const int* icp, double* carea, double* harea, double* sarea);
void cntc_getelementdivision(const int* ire, const int* icp, const int* lenarr, int* eldiv);
void cntc_getmaximumpressure(const int* ire, const int* icp, double* pnmax);
void cntc_getmaximumtraction(const int* ire, const int* icp, double* ptmax);
void cntc_getmaximumtemperature(const int* ire, const int* icp, double* t1max, double* t2max);
void cntc_getfielddata(const int* ire, const int* icp, const int* ifld, const int* lenarr, double* fld);
void cntc_gettractions(const int* ire, const int* icp, const int* lenarr, double* pn, double* px, double* py);
void cntc_getmicroslip(const int* ire, const int* icp, const int* lenarr, double* sx, double* sy);
void cntc_getdisplacements(const int* ire, const int* icp, const int* lenarr, double* un, double* ux, double* uy);
void cntc_getsensitivities(const int* ire, const int* icp, const int* lenout, const int* lenin, double* sens);
void cntc_getcalculationtime(const int* ire, const int* icp, double* tcpu, double* twall);
void cntc_resetcalculationtime(const int* ire, const int* icp);
void subs_getblocksize(const int* ire, const int* icp, const int* iblk, int* nx, int* ny, int* nz);
void subs_getresults(const int* ire, const int* icp, const int* iblk, const int* lenarr, const int* ncol, const int* icol, double* values);
void cntc_finalize(const int* ire);
void cntc_finalizelast(void);

#ifdef __cplusplus
}
#endif

#endif
