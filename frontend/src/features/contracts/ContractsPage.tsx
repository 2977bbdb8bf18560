import { Checkbox } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { Link, useParams } from '@tanstack/react-router'

import { contractsQuery, projectQuery } from '@/api/project'
import { useTitle } from '@/app/title'
import { showToast } from '@/app/toast'
import { ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { ConfirmInline } from '@/ui/ConfirmInline'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'
import { day } from '@/ui/format'
import { PageHead } from '@/ui/PageHead'
import { Row, Rows } from '@/ui/Rows'
import { StatusBadge } from '@/ui/StatusBadge'

import {
  type ContractBrief,
  type Project,
  type Template,
  templatesQuery,
  useAskForNda,
  useDropTemplate,
  useImportTemplate,
} from './api'
import { BeginContract } from './BeginContract'
import classes from './Contracts.module.css'
import { KIND_WORDS, progress } from './words'

/** The contracts of a project: how each stands, and beginning another. */
export function ContractsPage() {
  useTitle('Contracts')
  const { projectId } = useParams({ from: '/shell/projects/$projectId/contracts' })
  const { data: project, error } = useQuery(projectQuery(projectId))
  const { data: contracts, error: noContracts } = useQuery(contractsQuery(projectId))
  const runs = project?.mine.is_producer ?? false
  return (
    <div className="page stack">
      <PageHead title="Contracts">
        {project?.mine.is_team === false ? 'Your contracts with the studio.' : WHAT}
      </PageHead>
      <Refusal error={error ?? noContracts} />
      {project && contracts && (
        <div className={`columns ${classes.columns}`}>
          <div className="stack">
            <Listed contracts={contracts} project={project} />
          </div>
          {runs && (
            <div className="stack">
              <BeginContract project={project} contracts={contracts} />
              <Nda project={project} />
              <Templates project={project} />
            </div>
          )}
        </div>
      )}
    </div>
  )
}

const WHAT = 'Contracts between the studio and its designers. They are optional: a project works without one.'

function Listed({ contracts, project }: { contracts: readonly ContractBrief[]; project: Project }) {
  return (
    <Card aria-labelledby="contracts">
      <CardHead id="contracts" title="Contracts" count={contracts.length} />
      {contracts.length === 0 && (
        <div className="p-inset">
          <EmptyState head="No contracts yet." level={3}>
            {project.mine.is_producer
              ? 'Start one from the clause library. Have both parties’ lawyers review it.'
              : 'When the studio sends one, it appears here and you get an email.'}
          </EmptyState>
        </div>
      )}
      <Rows aria-label="Contracts">
        {contracts.map((contract) => {
          const { kind, text } = progress(contract)
          const waits = contract.my_party !== null && contract.waits_for.includes(contract.my_party)
          return (
            <Row key={contract.id} className={classes.row}>
              <div className="grow">
                <p className={waits ? 'strong' : undefined}>
                  <Link
                    className={` ${classes.over}`}
                    to="/projects/$projectId/contracts/$contractId"
                    params={{ projectId: project.id, contractId: contract.id }}
                  >
                    {contract.title}
                  </Link>
                </p>
                <p className="small mid">{`${KIND_WORDS[contract.kind]} with ${contract.designer.name}, created ${day(contract.created_at)}`}</p>
              </div>
              <StatusBadge kind={kind}>{text}</StatusBadge>
            </Row>
          )
        })}
      </Rows>
    </Card>
  )
}

function Nda({ project }: { project: Project }) {
  const ask = useAskForNda(project.id)
  return (
    <Card aria-labelledby="nda">
      <CardHead id="nda" title="NDA" />
      <div className={classes.form}>
        <Checkbox
          label="Require an NDA before designers see the project"
          description="A designer sees the brief, sound list and spec once both sides have signed."
          checked={project.nda_needed}
          onChange={({ currentTarget }) => ask.mutate(currentTarget.checked)}
        />
        <Refusal error={ask.error} />
      </div>
    </Card>
  )
}

function Templates({ project }: { project: Project }) {
  const studio = project.studio.id
  const { data: templates, error } = useQuery(templatesQuery(studio))
  const bring = useImportTemplate(studio)
  const drop = useDropTemplate(studio)
  const read = async (file: File | undefined) => {
    if (!file) return
    bring.mutate(await file.text(), { onSuccess: ({ name }) => showToast(`Template ${name} imported.`) })
  }
  return (
    <Card aria-labelledby="templates">
      <CardHead id="templates" title="Templates" note="in this studio" count={templates?.length ?? 0} />
      {templates?.length === 0 && (
        <p className={`small mid ${classes.part}`}>
          No templates yet. Save a contract as a template on its page, or import a TOML file.
        </p>
      )}
      <Rows aria-label="Templates">
        {templates?.map((template) => (
          <TemplateRow
            key={template.id}
            template={template}
            studioId={studio}
            onDelete={() =>
              drop.mutate(template.id, { onSuccess: () => showToast(`Template ${template.name} deleted.`) })
            }
          />
        ))}
      </Rows>
      <div className={classes.form}>
        <Refusal error={error ?? bring.error ?? drop.error} />
        <label className={`grid gap-1 ${classes.file}`}>
          <span className="small">Import template (TOML)</span>
          <input
            type="file"
            accept=".toml"
            onChange={({ currentTarget }) => {
              void read(currentTarget.files?.[0])
              currentTarget.value = ''
            }}
          />
        </label>
      </div>
    </Card>
  )
}

interface TemplateRowProps {
  template: Template
  studioId: string
  onDelete: () => void
}

function TemplateRow({ template: { id, name, kind }, studioId, onDelete }: TemplateRowProps) {
  const path = `/v1/studios/${studioId}/contract-templates/${id}`
  return (
    <Row className={classes.row}>
      <div className="grow">
        <p>{name}</p>
        <p className="small mid">{KIND_WORDS[kind]}</p>
      </div>
      <ButtonLink variant="quiet" href={`${path}/template.toml`} aria-label={`${name} as TOML`}>
        TOML
      </ButtonLink>
      <ButtonLink variant="quiet" href={`${path}/template.md`} aria-label={`${name} as Markdown`}>
        Markdown
      </ButtonLink>
      <ConfirmInline
        variant="quiet"
        aria-label={`Delete ${name}`}
        action={`Delete “${name}”`}
        consequence="It cannot be restored. Contracts made from it stay."
        onConfirm={onDelete}
      >
        Delete
      </ConfirmInline>
    </Row>
  )
}
