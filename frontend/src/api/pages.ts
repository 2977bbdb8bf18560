interface Page {
  next?: string | null
}

/** Every page, one after another; `onPage` receives the items so far, so that a long list can be shown while it loads. */
export async function everyPage<P extends Page>(
  read: (cursor: string | undefined) => Promise<P>,
  onPage?: (pages: readonly P[]) => void,
): Promise<P[]> {
  const pages: P[] = []
  let cursor: string | undefined
  do {
    const page = await read(cursor)
    pages.push(page)
    onPage?.(pages)
    cursor = page.next ?? undefined
  } while (cursor !== undefined)
  return pages
}
