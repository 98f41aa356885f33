# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers for other libraries: data frames, labelled arrays, tables of a notebook; and figures of the report."""
import importlib
import os
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from html import escape
from typing import Any

import numpy as np

from . import _core


class Tabular:
    """What has columns of numbers."""

    def columns(self) -> dict[str, np.ndarray]:
        """{name: array}, all of one length."""
        raise NotImplementedError

    def to_dataframe(self) -> Any:
        """`columns()` as a data frame.

        Returns
        -------
        pandas.DataFrame

        Raises
        ------
        ImportError
            Without pandas.

        Examples
        --------
        >>> result.to_dataframe().groupby("model").max_pressure.mean()
        """
        try:
            import pandas
        except ImportError as error:
            raise ImportError("to_dataframe needs pandas; do: apt install python3-pandas, or take columns(), which has "
                              "the same in numpy arrays") from error
        return pandas.DataFrame(self.columns())


def dataset_of(values: Mapping[str, tuple[Sequence[str], Any, Mapping[str, str]]], coordinates: Mapping[str, Any],
               attributes: Mapping[str, Any]) -> Any:
    """A xarray.Dataset of {name: (dimensions, values, attributes)}."""
    try:
        import xarray
    except ImportError as error:
        raise ImportError("to_xarray needs xarray; do: apt install python3-xarray") from error
    return xarray.Dataset(dict(values), coords=dict(coordinates), attrs=dict(attributes))


def html_table(title: str, heads: Sequence[str], rows: Iterable[Sequence[Any]]) -> str:
    """A table of a notebook: numbers with four digits."""
    def cell(value: Any) -> str:
        return escape(f"{value:.4g}" if isinstance(value, float) else str(value))

    body = "".join(f"<tr>{''.join(f'<td>{cell(value)}</td>' for value in row)}</tr>" for row in rows)
    head = "".join(f"<th>{escape(head)}</th>" for head in heads)
    return f"<p>{escape(title)}</p><table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def figures_module(name: str) -> Any:
    """A module of the plotting program."""
    folder = os.path.dirname(_core.figures_directory())
    if folder not in sys.path:
        sys.path.append(folder)
    try:
        return importlib.import_module(f"rollfem_figures.{name}")
    except ImportError as error:
        raise ImportError(f"reading results and drawing reports needs h5py and {folder}/rollfem_figures: {error}; "
                          "do: apt install python3-h5py") from error


def drawn(path: str, name: str) -> Any:
    """A figure of the report of what rollfem has written at a path."""
    found: dict[str, Callable[[], Any]] = figures_module("catalogue").figures(path)
    if name not in found:
        raise KeyError(f"{name}: allowed: {', '.join(found)}")
    figure = found[name]()
    if figure is None:
        raise ValueError(f"{name}: there is no data for this figure")
    return figure
