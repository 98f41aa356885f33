# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the commands study, compare and bench compute, and their part of the command line (`line`)."""
