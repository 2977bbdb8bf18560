import { useInfiniteQuery } from '@tanstack/react-query'
import { Link, type LinkProps } from '@tanstack/react-router'

import { useHotkeys } from '@/app/keys'
import { useTitle } from '@/app/title'
import { Button } from '@/ui/Button'
import { Card } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { ago } from '@/ui/format'
import { PageHead } from '@/ui/PageHead'
import { UnreadDot } from '@/ui/UnreadDot'
import { Refusal } from '@/ui/Refusal'
import { Row, Rows } from '@/ui/Rows'
import { ShowMore } from '@/ui/ShowMore'

import { type Notice, noticesQuery, useMarkRead } from './api'
import classes from './Notices.module.css'

/** What happened for the current person, the newest first; each leads to its page. */
export function NoticesPage() {
  useTitle('Notices')
  const list = useInfiniteQuery(noticesQuery)
  const { data, error } = list
  const mark = useMarkRead()
  const newest = data?.[0]
  const unread = data?.some(({ read_at }) => read_at === null) ?? false
  const markAll = () => {
    if (newest && unread && !mark.isPending) mark.mutate({ up_to: newest.id })
  }
  useHotkeys([{ keys: 'shift+r', label: 'Mark all as read', group: 'Notices', run: markAll }])
  return (
    <div className="page max-w-720px stack">
      <PageHead
        title="Notices"
        actions={
          newest && (
            <Button icon="tick" keys="shift+R" disabled={!unread || mark.isPending} onClick={markAll}>
              Mark all as read
            </Button>
          )
        }
      >
        The news that emails are about.{' '}
        <Link className="link" to="/account/notifications">
          Choose what is emailed to you
        </Link>
        .
      </PageHead>
      {[error, mark.error].map((error, at) => (
        <Refusal key={at} error={error} />
      ))}
      {data?.length === 0 && (
        <EmptyState head="No notices yet">
          Sounds to review, answers, mentions and contracts are announced here. Notices that you have read are kept for
          90 days.
        </EmptyState>
      )}
      {data && data.length > 0 && (
        <Card aria-label="Notices">
          <Rows>
            {data.map((notice) => (
              <NoticeRow key={notice.id} notice={notice} onRead={() => mark.mutate({ ids: [notice.id] })} />
            ))}
          </Rows>
        </Card>
      )}
      <ShowMore list={list}>Show earlier notices</ShowMore>
    </div>
  )
}

function NoticeRow({ notice, onRead }: { notice: Notice; onRead: () => void }) {
  const isNew = notice.read_at === null
  return (
    <Row data-read={!isNew || undefined}>
      <Link
        to={notice.path as LinkProps['to']}
        data-stop
        className={`grow block ${classes.notice}`}
        onClick={() => {
          if (isNew) onRead()
        }}
      >
        <span className="row">
          {isNew && <UnreadDot />}
          <span className={isNew ? 'strong' : 'mid'}>
            {isNew && <span className="visually-hidden">Unread: </span>}
            {notice.subject}
          </span>
          <time dateTime={notice.created_at} className="small dim end nowrap">
            {ago(notice.created_at)}
          </time>
        </span>
        <span className={`small mid overflow-hidden pre-line wrap-anywhere ${classes.text}`}>{notice.text}</span>
      </Link>
      {isNew && (
        <Button variant="quiet" className="small" onClick={onRead}>
          Mark as read<span className="visually-hidden">: {notice.subject}</span>
        </Button>
      )}
    </Row>
  )
}
