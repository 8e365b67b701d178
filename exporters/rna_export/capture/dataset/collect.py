"""Transfer of finished dataset files from workers to the dataset's folder."""

import hashlib
from dataclasses import dataclass

from rna_export.capture.blender_process.capture_worker import stored_name
from rna_export.capture.capture_tasks import Task
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.sample_files import check_whole
from rna_sdk.errors import CaptureError
from rna_work.cluster.store import Store
from rna_work.executors import Executor, check_shared
from rna_work.sources import Carried, InPlace

_MADE = ("train", "emission", "validation")
"""Folders of a dataset that captures fill, and need not read."""


@dataclass(frozen=True)
class Collector:
    """Files that workers write into the dataset's folder, or into a store that is collected here.

    store: the part of it that is this dataset's; None if workers see the folder.
    """

    dataset: Dataset
    executor: Executor
    store: Store | None

    @classmethod
    def of(cls, dataset: Dataset, executor: Executor, store: Store | None) -> "Collector":
        """Raises WorkError if a machine cannot write finished files."""
        if store is None:
            check_shared(executor, dataset.folder)
            return cls(dataset, executor, None)
        executor.on_every_node(store.check)
        return cls(dataset, executor, store.below(_name(dataset)))

    def carried(self) -> Carried:
        """The manifest for workers, with their inputs if they do not see the folder."""
        folder = self.dataset.folder.resolve()
        if self.store is None:
            return InPlace(folder / "manifest.json")
        others = [
            path
            for path in folder.rglob("*")
            if path.is_file() and _is_read(path.relative_to(folder).parts[0])
        ]
        return self.executor.carry(folder / "manifest.json", others)

    def fetch(self, missing: list[Task]) -> list[Task]:
        """Fetch the finished files of the store; returns the tasks without a whole one."""
        there = set() if self.store is None else self.store.names()
        return [
            task
            for task in missing
            if stored_name(task, self.dataset) not in there or not self._fetched(task)
        ]

    def _fetched(self, task: Task) -> bool:
        """Whether the file in the store is whole and here now; one that is not is removed."""
        assert self.store is not None
        try:
            self.finished(task)
        except CaptureError:
            self.store.remove(stored_name(task, self.dataset))
            return False
        return True

    def finished(self, task: Task) -> None:
        """A worker has finished a task.

        Raises CaptureError if its file is damaged, which is then deleted.
        """
        path = task.path(self.dataset)
        if self.store is not None and not path.is_file():
            self.store.get(stored_name(task, self.dataset), path)
            try:
                check_whole(path)
            except CaptureError:
                path.unlink()
                raise


def _is_read(name: str) -> bool:
    return name not in _MADE and not name.startswith(".")


def _name(dataset: Dataset) -> str:
    """A name that equal captures share, and others do not."""
    manifest = dataset.manifest
    identity = manifest.model_dump_json(include={"source_sha256", "arguments", "settings", "parts"})
    return f"{manifest.name}-{hashlib.sha256(identity.encode()).hexdigest()[:12]}"
