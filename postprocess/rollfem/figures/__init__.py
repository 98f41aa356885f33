# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures and pages of what rollfem has written, for reports and for `figure()` of results; without the compiled module."""
