"""The endpoint that reads several cues from one line."""

from typing import Annotated
from uuid import UUID

from fastapi import APIRouter, Query

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.web.http import DbSession, problems
from app.projects.errors import ProjectNotFound
from app.projects.queries import current_spec
from app.projects.service import project_access
from app.projects.specs.service import read_spec
from app.sound_lists import queries
from app.sound_lists.errors import MatrixInvalid
from app.sound_lists.matrix.rules import MAX_LINE_CHARS, matrix_cues, read_matrix
from app.sound_lists.matrix.schemas import MatrixRead, MatrixRow
from app.sound_lists.rules import LINES, folded, label

router = APIRouter(prefix="/v1", tags=["sound-lists"])


@router.get("/projects/{project_id}/cue-matrix", responses=problems(ProjectNotFound, MatrixInvalid))
def read_cue_matrix(
    project_id: UUID,
    session: DbSession,
    line: Annotated[str, Query(min_length=1, max_length=2 * MAX_LINE_CHARS, examples=["deck, sand × walk, run × 6"])],
    category: Annotated[str, Query(max_length=LINES["category"])] = "",
    actor: Actor = allows(Audience.PROJECT),
) -> MatrixRead:
    """Return the cues that a line makes under the names that the project's spec asks for; nothing is added."""
    project = project_access(session, actor, project_id).project
    naming = read_spec(current_spec(session, project_id).toml).for_category(category or None).naming
    try:
        cues = matrix_cues(read_matrix(line), category, naming.tokens, naming.separator)
    except ValueError as error:
        raise MatrixInvalid(str(error)) from None
    owners = queries.stem_owners(session, project_id, {folded(stem) for cue in cues for stem in cue.stems})
    rows = []
    for cue in cues:
        owned = next((owners[key] for stem in cue.stems if (key := folded(stem)) in owners), None)
        owner = label(project.cue_prefix, owned[1]) if owned else None
        rows.append(
            MatrixRow(name=cue.name, file_name=cue.file_name, stems=cue.stems, variations=cue.variations, owner=owner)
        )
    return MatrixRead(rows=rows)
