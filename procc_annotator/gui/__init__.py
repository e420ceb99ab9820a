"""The window, and all there is of Qt.

PySide puts a function of its own in the place of Python's import, which reads the source text of
every module that is imported after it, for those that want methods called in another style. Nothing
here does, and to look costs a tenth of the start.
"""

import builtins

import PySide6.QtCore  # noqa: F401  (it puts its function there)

builtins.__import__ = getattr(builtins, "__orig_import__", builtins.__import__)
