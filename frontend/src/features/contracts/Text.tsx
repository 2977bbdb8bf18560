import { createContext, Fragment, type ReactNode, useContext } from 'react'

import type { Block, Span } from './api'
import classes from './Contracts.module.css'

/** Draws the figures of a text where they can be changed; null leaves one as it is read. */
export const Figures = createContext<(name: string, text: string) => ReactNode>(() => null)

/** The text of a contract, as the PDF has it; tables with more rows than `folds` are opened by a press. */
export function Text({ blocks, folds = Infinity }: { blocks: readonly Block[]; folds?: number }) {
  return (
    <div className={`wrap-anywhere ${classes.text}`}>
      {grouped(blocks).map((group, index) =>
        Array.isArray(group) ? (
          <ul key={index}>
            {group.map((item, place) => (
              <li key={place}>
                <Spans spans={item.spans} />
              </li>
            ))}
          </ul>
        ) : (
          <One key={index} block={group} folds={folds} />
        ),
      )}
    </div>
  )
}

/** Items that follow one another are one list. */
function grouped(blocks: readonly Block[]): (Block | Block[])[] {
  const groups: (Block | Block[])[] = []
  for (const block of blocks) {
    const last = groups.at(-1)
    if (block.kind !== 'item') groups.push(block)
    else if (Array.isArray(last)) last.push(block)
    else groups.push([block])
  }
  return groups
}

/** The column heads of a table, by which one table is distinguished from the next. */
function wordsOf(head: readonly Span[][]): string {
  return head.map((cell) => cell.map(({ text }) => text).join('')).join(', ')
}

function One({ block, folds }: { block: Block; folds: number }) {
  if (block.kind === 'head') {
    const Head = block.level === 1 ? 'h2' : 'h3'
    return (
      <Head>
        <Spans spans={block.spans} />
      </Head>
    )
  }
  if (block.kind === 'table') {
    const [head = [], ...rows] = block.rows
    const table = (
      // A table wider than a telephone is moved by itself, by keys too.
      // eslint-disable-next-line jsx-a11y/no-noninteractive-tabindex
      <div className={classes.table} tabIndex={0} role="region" aria-label={`Table: ${wordsOf(head)}`}>
        <table>
          <thead>
            <tr>
              {head.map((cell, place) => (
                <th key={place} scope="col">
                  <Spans spans={cell} />
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {rows.map((row, place) => (
              <tr key={place}>
                {row.map((cell, column) => (
                  <td key={column}>
                    <Spans spans={cell} />
                  </td>
                ))}
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    )
    if (rows.length <= folds) return table
    return (
      <details>
        <summary>{`Table of ${rows.length}: ${wordsOf(head)}`}</summary>
        {table}
      </details>
    )
  }
  return (
    <p>
      <Spans spans={block.spans} />
    </p>
  )
}

function Spans({ spans }: { spans: readonly Span[] }) {
  const figure = useContext(Figures)
  return spans.map(({ text, strong, emphatic, field }, index) => {
    const words = (field !== '' && figure(field, text)) || text
    if (strong) return <strong key={index}>{words}</strong>
    return emphatic ? <em key={index}>{words}</em> : <Fragment key={index}>{words}</Fragment>
  })
}
