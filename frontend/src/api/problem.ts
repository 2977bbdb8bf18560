/** One field that does not fit, as problem details name it. */
export interface FieldProblem {
  /** Where: a field name, or a path such as "cues.3.duration_s". */
  field: string
  message: string
}

/** A refusal of the server (RFC 9457), or a line that dropped before it could answer. */
export class ApiProblem extends Error {
  readonly status: number
  /** Stable, for code to decide by: "delivery-closed". */
  readonly code: string
  readonly detail: string
  /** What to do about it, in words. */
  readonly fix: string
  readonly errors: readonly FieldProblem[]
  /** Whatever else the document carries. */
  readonly more: Readonly<Record<string, unknown>>

  constructor(
    status: number,
    given: {
      code: string
      detail: string
      fix?: string
      errors?: readonly FieldProblem[]
      more?: Readonly<Record<string, unknown>>
    },
  ) {
    super(given.detail)
    this.name = 'ApiProblem'
    this.status = status
    this.code = given.code
    this.detail = given.detail
    this.fix = given.fix ?? ''
    this.errors = given.errors ?? []
    this.more = given.more ?? {}
  }

  /** What stands against one field, if anything does. */
  of(field: string): FieldProblem | undefined {
    return this.errors.find((error) => error.field === field)
  }
}

const isRecord = (value: unknown): value is Record<string, unknown> => typeof value === 'object' && value !== null
const textOf = (value: unknown): string | undefined => (typeof value === 'string' && value !== '' ? value : undefined)

function errorsOf(value: unknown): FieldProblem[] {
  if (!Array.isArray(value)) return []
  return value
    .filter(isRecord)
    .map((error) => ({ field: textOf(error.where) ?? '', message: textOf(error.message) ?? '' }))
}

/** Read a refusal; a body that is not a problem document still becomes a sentence. */
export function problemOf(status: number, body: unknown): ApiProblem {
  if (!isRecord(body) || (textOf(body.detail) === undefined && textOf(body.title) === undefined)) {
    return new ApiProblem(status, {
      code: `http-${status}`,
      detail:
        status >= 500
          ? 'Something went wrong on the server. Your work is safe. Try again.'
          : `The server refused the request (${status}).`,
    })
  }
  const { code, detail, title, fix, errors, ...more } = body
  return new ApiProblem(status, {
    code: textOf(code) ?? `http-${status}`,
    detail: textOf(detail) ?? textOf(title) ?? '',
    fix: textOf(fix),
    errors: errorsOf(errors),
    more,
  })
}

/** The line dropped, or the server does not run: nothing was answered. */
export const networkError = (): ApiProblem =>
  new ApiProblem(0, {
    code: 'line-lost',
    detail: 'Can’t reach Soundlist.',
    fix: 'What you typed is kept. Try again in a moment.',
  })
