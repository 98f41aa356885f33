# SPDX-License-Identifier: LGPL-2.1-or-later
"""What results, tables and cases have in common: data frames and labelled arrays for other libraries, tables of a notebook,
folders and files, figures of the report."""
import importlib
import inspect
import operator
import os
import textwrap
from collections.abc import Callable, Iterable, Mapping, Sequence
from html import escape
from typing import Annotated, Any, TypeVar, get_origin

import numpy as np

from .errors import FileError

Kind = TypeVar("Kind", bound=type)


def notes(kind: type) -> dict[str, Any]:
    """The fields of a class that say what they are: `x: Annotated[float, "mm"]`."""
    return {name: hint for name, hint in inspect.get_annotations(kind).items() if get_origin(hint) is Annotated}


def documented(kind: Kind) -> Kind:
    """Lists the fields of a class in its docstring, as what they are annotated with."""
    return listed(kind, {name + ("" if hint.__origin__ is Any else f" ({inspect.formatannotation(hint.__origin__)})"):
                         "; ".join(hint.__metadata__) for name, hint in notes(kind).items()})


def listed(kind: Kind, attributes: Mapping[str, str]) -> Kind:
    """Lists attributes of a class in its docstring."""
    rows = (textwrap.fill(f"{name}: {words}", 116, initial_indent=4 * " ", subsequent_indent=8 * " ", break_on_hyphens=False)
            for name, words in attributes.items())
    kind.__doc__ = "\n".join([inspect.cleandoc(kind.__doc__ or ""), "", "Attributes:", *rows])
    return kind


def forwarded(name: str, doc: str) -> Any:
    """An attribute that is one of another's, which cannot be set."""
    return property(operator.attrgetter(name), doc=doc)


def package(name: str, user: str, otherwise: str = "") -> Any:
    """A package that not everybody has, for a user that "needs" it."""
    try:
        return importlib.import_module(name)
    except ImportError as error:
        name = name.split(".")[0]
        raise ImportError(f"{user} {name}; do: apt install python3-{name}{otherwise}") from error


class Tabular:
    """What has columns of numbers."""

    _columns: Iterable[str] = ()  # the attributes that are columns

    def columns(self) -> dict[str, np.ndarray]:
        """All rows.

        Returns:
            Arrays by name, one entry for each row.

        >>> rollfem.wheelset("cases/manchester_A22.toml").columns()["conicity_wave"]
        """
        return {name: getattr(self, name) for name in self._columns}

    def to_dataframe(self) -> Any:
        """`columns()` as a data frame.

        Returns:
            pandas.DataFrame: One row for each entry of the columns.
        Raises:
            ImportError: Without pandas.

        >>> result.to_dataframe().groupby("model").max_pressure.mean()
        """
        pandas = package("pandas", "to_dataframe needs", ", or take columns(), which has the same in numpy arrays")
        return pandas.DataFrame(self.columns())


#: Of labelled arrays: {name: (dimensions, values, attributes)}, coordinates, attributes of the whole.
Labelled = tuple[Mapping[str, tuple[Sequence[str], Any, Mapping[str, str]]], Mapping[str, Any], Mapping[str, Any]]


class Gridded(Tabular):
    """What has numbers over axes."""

    def _labelled(self, *which: Any, **named: Any) -> Labelled:
        raise NotImplementedError

    def to_xarray(self, *which: Any, **named: Any) -> Any:
        """All numbers (and fields) with their axes and units.

        Args:
            *which: As of `columns`.
            **named: As of `columns`.
        Returns:
            xarray.Dataset: Of a ModelResult: numbers over point_index (from 0), fields over point_index, y and x (mm);
                fields of load points that do not keep them are nan. Of a Sweep or Table: over its axes.
        Raises:
            ImportError: Without xarray.

        >>> result["halfspace"].to_xarray().pressure.sel(x=0.0, method="nearest")
        >>> sweep.to_xarray().traction_coefficient.plot()
        >>> table.to_xarray().longitudinal_force.isel(spin=2, lateral=0).plot()
        """
        xarray = package("xarray", "to_xarray needs")
        values, coordinates, attributes = self._labelled(*which, **named)
        return xarray.Dataset(dict(values), coords=dict(coordinates), attrs=dict(attributes))


class OverAxes(Gridded):
    """What has an array over all its axes for each number."""

    axes: dict[str, np.ndarray]

    @property
    def shape(self) -> tuple[int, ...]:
        """Number of values of each axis."""
        return tuple(len(values) for values in self.axes.values())

    def _places(self) -> dict[str, np.ndarray]:
        """The columns of the axes."""
        return {name: grid.ravel() for name, grid in zip(self.axes, np.meshgrid(*self.axes.values(), indexing="ij"))}

    def _over_axes(self, columns: Mapping[str, np.ndarray], unit: Callable[[str], str], attributes: Mapping[str, Any]) -> Labelled:
        """Labelled arrays of columns, with their units."""
        return ({name: (tuple(self.axes), column.reshape(self.shape), {"units": unit(name)})
                 for name, column in columns.items() if name not in self.axes}, self.axes, attributes)


class Written(Tabular):
    """What rollfem writes to a folder, with the figures of its report."""

    kind = ""  # of reader.KINDS
    first_figure = ""
    drawn_from = ""  # the file that reports are drawn from; otherwise the folder

    @property
    def labels(self) -> dict[str, str]:
        """Of the models in figures, by name."""
        return {model.name: model.label for model in getattr(self, "models", ())}

    def _contents(self) -> Mapping[str, str | bytes]:
        """The files by their names."""
        raise NotImplementedError

    def _store(self, folder: str, report: bool) -> str:
        """Writes the folder; why its report could not be drawn, or empty."""
        from . import _core
        _core.write_files(folder, dict(self._contents()))
        return _core.draw(os.path.join(folder, self.drawn_from)) if report else ""

    def figure(self, name: str | None = None) -> Any:
        """A figure of the report.

        Args:
            name: Of its file in figures/, without .svg: of a result "creep_curve" (the default), "path_x", "outlines",
                "pressure_map_halfspace", ...; with several patches "s1_path_x", "wheelset", "positions", ...; of a table
                "table_curves" (the default), "table_surfaces", "table_ratios", "table_shifts", "table_wheels",
                "table_errors"; of a study "error_unknowns", ...
        Returns:
            Figure: Notebooks show it; `figure.save("curve.svg")` writes it.
        Raises:
            KeyError: There is no such figure; the message names those there are.
            ValueError: There is no data for it.
            ImportError: Without h5py.

        >>> result.figure("path_x")
        >>> rollfem.study("cases/thesis_a.toml").figure("error_unknowns")
        """
        from .figures.page import drawing
        asked = self.first_figure if name is None else name
        found = {file.removesuffix(".svg"): draw for file, _, draw in drawing(self).captioned(self)}
        if asked not in found:
            raise KeyError(f"{asked}: allowed: {', '.join(found)}")
        if (figure := found[asked]()) is None:
            raise ValueError(f"{asked}: there is no data for this figure")
        return figure

    def write(self, folder: str | os.PathLike[str], report: bool = False) -> str | os.PathLike[str]:
        """Writes the folder that the command writes (`rollfem run`, `table`, `study`, ...), whole or not at all.

        Args:
            folder: An earlier result in it is replaced.
            report: Also draws figures and the page, which takes some seconds.
        Returns:
            The folder.
        Raises:
            FileError: It cannot be written.
            InputError: This is a Result that was read.

        >>> result.write("results/crowned", report=True)
        >>> rollfem.table("cases/thesis_a.toml").write("results/thesis_a_table")
        """
        if problem := self._store(os.fspath(folder), report):
            raise FileError(f"{folder}: the results were written, but the report was not drawn: {problem}")
        return folder


class InFile:
    """What has a file of its own, which can be read again."""

    def _text_in(self, folder: str) -> str:
        """The text of a file in a folder."""
        raise NotImplementedError

    def write(self, file: str | os.PathLike[str]) -> str | os.PathLike[str]:
        """Writes a file that can be read again: a case, whose paths are changed to lead from its folder, or the curve of a
        profile (s, y, z in mm, angle in degrees, curvature in 1/mm).

        Args:
            file: Its name; that of a profile ends in .csv.
        Returns:
            The same name.
        Raises:
            FileError: The file cannot be written.

        >>> rollfem.solve(case.write("heavy.toml"))
        >>> rollfem.Profile("worn.whl", smoothing=0.01).write("mended.csv")
        """
        try:
            with open(file, "w", encoding="utf-8") as out:
                out.write(self._text_in(os.path.dirname(os.path.abspath(file))))
        except OSError as error:
            raise FileError(f"{os.fspath(file)}: cannot be written: {error.strerror}") from error
        return file


def html_table(title: str, heads: Sequence[str], rows: Iterable[Sequence[Any]]) -> str:
    """A table of a notebook: numbers with four digits."""
    def cell(value: Any) -> str:
        return escape(f"{value:.4g}" if isinstance(value, float) else str(value))

    body = "".join(f"<tr>{''.join(f'<td>{cell(value)}</td>' for value in row)}</tr>" for row in rows)
    head = "".join(f"<th>{escape(head)}</th>" for head in heads)
    return f"<p>{escape(title)}</p><table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"
