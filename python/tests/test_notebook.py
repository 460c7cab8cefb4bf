"""What a notebook is given to show."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree

import chordal
from conftest import BROKEN, PART


def test_a_program_shows_picture_summary_and_problems() -> None:
    program = chordal.loads(BROKEN, "haas-vf2", name="<b>.nc")
    page = program._repr_html_()
    assert "data:image/svg+xml;base64," in page and "Haas VF-2" in page
    assert "CH401" in page and "^^^" in page
    # A problem looks as on the setup sheet.
    assert program.errors[0].html in program.report() and program.errors[0].html in page
    assert "&lt;b&gt;.nc" in page and "<b>" not in page
    assert ElementTree.fromstring(program._repr_svg_()).tag.endswith("svg")
    assert "no problems" in chordal.loads("G21 G0 X1.\nM30\n", "haas-vf2")._repr_html_()


def test_a_setup_sheet_is_one_page_and_the_same_again() -> None:
    program = chordal.loads(BROKEN, "haas-vf2", name="in/<b>.nc")
    page = program.report()
    assert page.startswith("<!DOCTYPE html>") and page == program.report()
    assert "Do not run: 1 error." in page and "&lt;b&gt;.nc" in page and "<b>" not in page
    assert "<dd>today</dd>" in program.report(date="today") and "<dt>Date</dt>" not in page


def test_pictures_have_their_size() -> None:
    program = chordal.loads(PART, "haas-vf2")
    png = program.png(400, 300)
    assert png[:8] == b"\x89PNG\r\n\x1a\n"
    assert (int.from_bytes(png[16:20]), int.from_bytes(png[20:24])) == (400, 300)


def test_a_table_shows_its_first_rows() -> None:
    table = chordal.loads(PART, "haas-vf2").path()
    page = table._repr_html_()
    assert page.count("<tr>") == 1 + min(len(table), 8) and f"{len(table)} rows" in page
