/** The guide that fits each page: an address below /help, which the server builds from the documents. */

const GUIDES: readonly [RegExp, string][] = [
  [/\/(sound-list|kits)\b/, 'how-to/sound-list'],
  [/\/adopt\b/, 'how-to/existing-audio'],
  [/\/(brief|references)\b/, 'how-to/brief'],
  [/\/voice-lines\b/, 'how-to/voice-lines'],
  [/\/(review|takes|reasons|approvers|approval|today|sharing|playlists|listen)\b/, 'how-to/review'],
  [/\/(packs|game-files|placeholders|libraries|credits)\b/, 'how-to/game-files'],
  [/\/(builds|drift|listening|recording|game-tasks)\b/, 'how-to/builds'],
  [/\/(people|roster|postings|posting)\b/, 'how-to/designers'],
  [/\/(milestones|money|hours|progress|plan)\b/, 'how-to/money'],
  [/\/(contracts|changes|ending)\b/, 'how-to/contracts'],
  [/\/spec\b/, 'reference/delivery-spec'],
  [/\/(desk|deliveries)\b/, 'how-to/deliver'],
  [/\/(webhooks|notices|notifications)\b/, 'how-to/notifications'],
  [/\/(account|studio|sign-in|sign-up|tokens)\b/, 'how-to/accounts'],
  [/\/operations\b/, 'how-to/operate'],
  [/^\/projects\/new$/, 'tutorials/first-project'],
]

/** The address of the guide to a page; the first page of the guides where none fits better. */
export function helpFor(pathname: string): string {
  const guide = GUIDES.find(([page]) => page.test(pathname))?.[1]
  return guide === undefined ? '/help/' : `/help/${guide}.html`
}
