"""Texts and tables as HTML."""

import html


def escaped(text):
    return html.escape(str(text))


def number(value, factor=1.0):
    if value is None:
        return "none"
    value *= factor
    return f"{value:.0f}" if value == int(value) and abs(value) < 1e9 else f"{value:.4g}"


def table(header, rows):
    head = "".join(f"<th>{escaped(cell)}</th>" for cell in header)
    body = "".join("<tr>" + "".join(f"<td>{escaped(cell)}</td>" for cell in row) + "</tr>" for row in rows)
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"
