"""``python -m procc_annotator`` is the ``procc-annotator`` command."""

from procc_annotator.cli.main import run

if __name__ == "__main__":
    run()
