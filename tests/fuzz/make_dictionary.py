"""Writes what a study file may consist of as a dictionary of libFuzzer.

make_dictionary.py PARAMETERS DICTIONARY takes tables, keys, defaults and words from the reference of
parameters, which `zona reference` writes.
"""
import re
import sys


def words_of(reference):
    words = {"base = ", "study = ", "\n#set ", "[[", "]]", "'''", '"""', "nan", "inf", "pi", " ? 1 : "}
    for line in reference.splitlines():
        heading = re.match(r"#+ (\[\[?[\w.]+\]\]?)", line)
        if heading:
            words.add(heading[1] + "\n")
        row = re.match(r"\| `(\w+)` \| (.*?) \| (.*?) \|", line)
        if not row:
            continue
        words.add(f"\n{row[1]} = ")
        words.update(re.findall(r"`([^`]+)`", row[2]))
        words.update(re.findall(r"\b[a-z][a-z_]{3,}\b", row[3]))
    return words


def escaped(word):
    return "".join(c if 32 <= ord(c) < 127 and c not in '"\\' else "".join(f"\\x{b:02x}" for b in c.encode())
                   for c in word)


with open(sys.argv[1], encoding="utf-8") as reference:
    entries = sorted(words_of(reference.read()))
with open(sys.argv[2], "w", encoding="ascii") as dictionary:
    dictionary.writelines(f'"{escaped(word)}"\n' for word in entries if len(word) < 60)
