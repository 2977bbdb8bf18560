import { useQuery } from '@tanstack/react-query'

import { Dialog } from '@/app/Dialog'
import type { OpenedProps } from '@/app/LazyDialog'
import { ButtonLink } from '@/ui/Button'
import { Icon } from '@/ui/Icon'
import { ErrorBanner } from '@/ui/ErrorBanner'

import { partOf, type Reference, TEXT_BYTES, textQuery } from './api'
import classes from './References.module.css'
import { factsOf, titleOf } from './words'

interface ReferenceViewerProps extends OpenedProps {
  reference: Reference | null
}

/** A picture or a text in full, over the page. */
export function ReferenceViewer({ reference, opened, onClose }: ReferenceViewerProps) {
  return (
    <Dialog
      title={reference ? titleOf(reference) : ''}
      opened={opened}
      onClose={onClose}
      size={reference?.version.kind === 'text' ? 720 : 1200}
    >
      {reference && <Shown reference={reference} />}
    </Dialog>
  )
}

function Shown({ reference }: { reference: Reference }) {
  const { version, terms } = reference
  return (
    <div className={`grid gap-3 ${classes.viewer}`}>
      {version.kind === 'text' ? (
        <Text reference={reference} />
      ) : (
        <img src={partOf(version.id, 'view')} alt={titleOf(reference)} />
      )}
      <div className="flex wrap items-center gap-2-3">
        <span className="small dim">{factsOf(reference)}</span>
        {terms && (
          <span className={`small tone-warn flex items-start gap-1 toned ${classes.terms}`}>
            <Icon name="triangle" />
            <span>{terms}</span>
          </span>
        )}
        <ButtonLink className="end" icon="download" href={`${partOf(version.id, 'file')}?download=true`} download>
          Download
        </ButtonLink>
      </div>
    </div>
  )
}

function Text({ reference }: { reference: Reference }) {
  const { version } = reference
  const { data: text, error } = useQuery(textQuery(reference.project_id, version.id))
  if (error) return <ErrorBanner detail={error.message} fix="Download it instead." />
  return (
    <>
      {/* Focusable, so that a long text can be scrolled without a pointer. */}
      {/* eslint-disable-next-line jsx-a11y/no-noninteractive-tabindex */}
      <div className={`pre-wrap wrap-anywhere ${classes.text}`} tabIndex={0} role="region" aria-label="Text">
        {text ?? version.excerpt}
      </div>
      {(version.file_bytes ?? 0) > TEXT_BYTES && <p className="small dim">Only the beginning is shown.</p>}
    </>
  )
}
