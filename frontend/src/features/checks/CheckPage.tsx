import { useQuery } from '@tanstack/react-query'
import { useParams } from '@tanstack/react-router'

import { queryKeys } from '@/api/queryKeys'
import { useTitle } from '@/app/title'
import { EmptyState } from '@/ui/EmptyState'
import { PageSkeleton } from '@/ui/Skeleton'

import classes from './Check.module.css'
import { blocksOf, type Inline } from './markdown'

/** The pages of docs/checks, made from each check's own words; one is fetched when it is asked for. */
const PAGES = import.meta.glob<string>(['../../../../docs/checks/*.md', '!**/README.md'], {
  query: '?raw',
  import: 'default',
})

const pageOf = (check: string) => Object.entries(PAGES).find(([path]) => path.endsWith(`/${check}.md`))?.[1]

/** What one check looks for, why, and how to put right what it finds. */
export function CheckPage() {
  const { check } = useParams({ from: '/guest/checks/$check' })
  useTitle(check)
  const load = pageOf(check)
  const { data: text } = useQuery({
    queryKey: queryKeys.checkPage(check),
    queryFn: () => load?.() ?? '',
    enabled: load !== undefined,
    staleTime: Infinity,
  })
  if (load === undefined) {
    return (
      <div className="page">
        <EmptyState level={1} head={`There is no check called ${check}.`}>
          The finding shows what was measured, the limit and how to fix it.
        </EmptyState>
      </div>
    )
  }
  if (text === undefined) return <PageSkeleton />
  return (
    <article className={`page max-w-720px ${classes.check}`}>
      {blocksOf(text).map((block, index) => {
        if (block.kind === 'head') {
          return block.level === 1 ? (
            <h1 key={index} className="font-mono">
              {block.text}
            </h1>
          ) : (
            <h2 key={index}>{block.text}</h2>
          )
        }
        if (block.kind === 'list') {
          return (
            <ul key={index}>
              {block.items.map((item, at) => (
                <li key={at}>
                  <Line parts={item} />
                </li>
              ))}
            </ul>
          )
        }
        return (
          <p key={index}>
            <Line parts={block.parts} />
          </p>
        )
      })}
    </article>
  )
}

function Line({ parts }: { parts: readonly Inline[] }) {
  return (
    <>
      {parts.map(({ text, code }, index) =>
        code ? (
          <code key={index} className="mono">
            {text}
          </code>
        ) : (
          <span key={index}>{text}</span>
        ),
      )}
    </>
  )
}
