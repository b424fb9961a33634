"""For programs that are extensions of Suffuse (docs/extensions.md).

    from suffuse import extension
    job = extension.job()
    job.write(changed(job.painting, **job.values))
"""

import json
import os
import sys

import suffuse


class Job:
    """What an extension was started for.

    values: of the fields, by their ids; files are paths.
    selection: the ids of the selected strokes, a frozenset.
    layer: the id of the group that is painted on, or None.
    time: the moment that is looked at, seconds.
    language: of the person, as "en", "de", "zh_CN", "fr", "es" or "ja".
    """

    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            data = json.load(file)
        if data.get("format") != "suffuse-extension-job" or data.get("version") != 1:
            raise suffuse.DataError(f"{path}: is no job of version 1")
        self.values = data["values"]
        self.selection = frozenset(data["selection"])
        self.layer = data["layer"]
        self.time = data["time"]
        self.language = data["language"]
        self._painting_path = data["painting"]
        self._result_path = data["result"]
        self._painting = None

    @property
    def painting(self):
        """The painting, or the part of it, that was passed."""
        if self._painting is None:
            self._painting = suffuse.open(self._painting_path)
        return self._painting

    def write(self, painting):
        """Hands over what the painting, or the part of it, becomes."""
        painting.save(self._result_path)


def job():
    """The job of this program. Raises FileError where it was not started by Suffuse."""
    path = os.environ.get("SUFFUSE_JOB")
    if not path:
        raise suffuse.FileError("SUFFUSE_JOB is not set: start the program by Suffuse or by suffuse-cli extension run")
    return Job(path)


def progress(share, what=""):
    """Tells that a share of the work, from 0 to 1, is done."""
    print(f"progress: {share:.4f} {what}".rstrip(), file=sys.stderr, flush=True)


def say(text):
    """Says a sentence about the result, which is shown once it is there."""
    print("say: " + " ".join(str(text).split()), file=sys.stderr, flush=True)


def fail(text):
    """Ends the program with a sentence that says what is wrong and what to do."""
    print("error: " + " ".join(str(text).split()), file=sys.stderr, flush=True)
    sys.exit(1)
