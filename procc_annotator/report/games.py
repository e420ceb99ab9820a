"""A tree of folders in a format of one file a game: one in each folder, as its loader expects."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from dataclasses import field as attribute

from procc_annotator.io.annotation_files.exchange import ExchangedFrame, Remarks, WriteContext


@dataclass
class Game:
    """The frames of one folder.

    Attributes:
        folder: below the output; empty for its top.
        frames: called without the folder, as the file of the game calls them.
        whole: how each is called in the set, by its name here.
    """

    folder: str
    frames: list[ExchangedFrame] = attribute(default_factory=list)
    whole: dict[str, ExchangedFrame] = attribute(default_factory=dict)

    def called(self, name: str) -> str:
        """How a frame of this game is called in the set."""
        return self.whole[name].name if name in self.whole else name


def games_of(frames: Iterable[ExchangedFrame], pictures: str) -> list[Game]:
    """The frames by their folders, in the order they come in.

    Args:
        frames: of a set, which may be in a tree.
        pictures: the folder that the format has the pictures of a game in (``img1``): it is no
            part of the game's name.
    """
    games: dict[str, Game] = {}
    for frame in frames:
        folder, _, name = frame.name.rpartition("/")
        if folder == pictures or folder.endswith(f"/{pictures}"):
            folder = folder[: -len(pictures)].rstrip("/")
        game = games.setdefault(folder, Game(folder))
        picture = None if frame.picture is None else frame.picture.rpartition("/")[2]
        game.frames.append(replace(frame, name=name, picture=picture))
        game.whole[name] = frame
    return list(games.values())


def write_game(game: Game, writing: WriteContext, write: Callable[[WriteContext], None]) -> None:
    """Write a game into its folder, and count and tell what became of it with the whole set.

    Args:
        game: its frames.
        writing: of the whole set.
        write: writes the game's frames by what it is given.
    """

    def put(name: str, data: bytes) -> bool:
        return writing.put(f"{game.folder}/{name}" if game.folder else name, data)

    own = replace(writing, put=put, problems=[], remarks=Remarks(), frames=0, elements=0, points=0)
    write(own)
    prefix = f"{game.folder}/" if game.folder else ""
    writing.problems += [prefix + problem for problem in own.problems]
    writing.remarks.take(own.remarks, game.called)
    writing.frames += own.frames
    writing.elements += own.elements
    writing.points += own.points
