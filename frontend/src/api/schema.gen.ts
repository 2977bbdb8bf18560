// Made from openapi.json by "npm run gen"; edits are lost.

export interface paths {
    "/v1/session": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Session
         * @description Return whether the caller is signed in, and the token that the page's writes must carry.
         */
        get: operations["read_session"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/demo/part/{part}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /**
         * Play Demo Part
         * @description Play another person of the demo; there is no such thing outside of it.
         */
        put: operations["play_demo_part"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/sign-in": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Sign In
         * @description Sign in with address and password.
         */
        post: operations["sign_in"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/sign-out": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Sign Out
         * @description Sign this browser out.
         */
        post: operations["sign_out"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/sign-up": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Sign Up
         * @description Return whether anyone may open an account here, and whether by a mailed link.
         */
        get: operations["read_sign_up"];
        put?: never;
        /**
         * Sign Up
         * @description Create an account with a new studio, and sign in; on a server without mail only.
         */
        post: operations["sign_up"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/sign-ups/{secret}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Sign Up Link
         * @description Show the holder of a mailed link the address that it opens an account for.
         */
        get: operations["read_sign_up_link"];
        put?: never;
        /**
         * Finish Sign Up
         * @description Create the account of a mailed link with a new studio, and sign in.
         */
        post: operations["finish_sign_up"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/sign-ups": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Request Sign Up
         * @description Mail a link that opens an account; the answer is the same for an address that has one.
         */
        post: operations["request_sign_up"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/password-resets": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Request Password Reset
         * @description Mail a link for a new password; the answer is the same for an unknown address.
         */
        post: operations["request_password_reset"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/password-resets/{secret}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Set Password By Link
         * @description Set a new password by the mailed link, end every other sign-in, and sign in.
         */
        post: operations["set_password_by_link"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/me": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Me
         * @description Return who is signed in, and everything they can open.
         */
        get: operations["read_me"];
        /**
         * Change My Name
         * @description Change the caller's name.
         */
        put: operations["change_my_name"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/me/sign-ins": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List My Sign Ins
         * @description Return the browsers in which the caller is signed in, the one used last first.
         */
        get: operations["list_my_sign_ins"];
        put?: never;
        post?: never;
        /**
         * End My Other Sign Ins
         * @description Sign every other browser of the caller out.
         */
        delete: operations["end_my_other_sign_ins"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/me/sign-ins/{sign_in_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        post?: never;
        /**
         * End My Sign In
         * @description Sign one of the caller's browsers out.
         */
        delete: operations["end_my_sign_in"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/me/email-verifications": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Request Email Verification
         * @description Mail the caller a link that verifies their address.
         */
        post: operations["request_email_verification"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/email-verifications/{secret}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Verify Email
         * @description Verify the caller's address by the link mailed to it.
         */
        post: operations["verify_email"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/me/password": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /**
         * Change My Password
         * @description Change the caller's password, and end their other sign-ins.
         */
        put: operations["change_my_password"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/studios": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Create Studio
         * @description Open a further studio, with the caller as its producer.
         */
        post: operations["create_studio"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/studios/{studio_id}/people": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List People
         * @description Return the people of the studio.
         */
        get: operations["list_people"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/studios/{studio_id}/people/{person_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /**
         * Change Member Roles
         * @description Change a member's role in the studio; it always keeps a producer.
         */
        put: operations["change_member_roles"];
        post?: never;
        /**
         * Remove Member
         * @description Remove a member from the studio; it always keeps a producer.
         */
        delete: operations["remove_member"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/studios/{studio_id}/invitations": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Studio Invitations
         * @description Return the invitations that wait for an answer.
         */
        get: operations["list_studio_invitations"];
        put?: never;
        /**
         * Invite Member
         * @description Mail an invitation to the studio; the answer does not reveal whether the address has an account.
         */
        post: operations["invite_member"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/studios/{studio_id}/invitations/{studio_invitation_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        post?: never;
        /**
         * Revoke Studio Invitation
         * @description Withdraw an invitation into the studio.
         */
        delete: operations["revoke_studio_invitation"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/studio-invitations/{secret}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Studio Invitation
         * @description Show the holder of a link what they are invited to.
         */
        get: operations["read_studio_invitation"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/studio-invitations/{secret}/accept": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Accept Studio Invitation
         * @description Join the studio with the invited address's account, made now if there is none, and sign in.
         */
        post: operations["accept_studio_invitation"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/studios/{studio_id}/calendar": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Studio Calendar
         * @description Return the studio's time zone and holidays, by which working days are counted.
         */
        get: operations["get_studio_calendar"];
        /**
         * Save Studio Calendar
         * @description Replace the studio's time zone and holidays. For a cue that waits already, a holiday entered now is ignored.
         */
        put: operations["save_studio_calendar"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Projects
         * @description Return the projects of the caller's studios and engagements, newest first.
         */
        get: operations["list_projects"];
        put?: never;
        /**
         * Create Project
         * @description Open a project with the field's default spec; its creator is the approver until another is named.
         */
        post: operations["create_project"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Project
         * @description Return a project as its page heads it.
         */
        get: operations["read_project"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        /**
         * Change Project
         * @description Change what a project is called, or put it away.
         */
        patch: operations["change_project"];
        trace?: never;
    };
    "/v1/projects/{project_id}/studio-calendar": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Project Calendar
         * @description Return time zone and holidays of the project's studio, by which both sides count its working days.
         */
        get: operations["get_project_calendar"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/liaisons/{person_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /**
         * Add Liaison
         * @description Make a member of the studio a liaison of this project.
         */
        put: operations["add_liaison"];
        post?: never;
        /**
         * Remove Liaison
         * @description Remove a liaison.
         */
        delete: operations["remove_liaison"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/approver": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /**
         * Name Approver
         * @description Make a liaison the approver, or become it as a producer; the reason is kept.
         */
        put: operations["name_approver"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/approver-invitations": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Invite Approver
         * @description Invite an address into the studio as this project's approver; a member becomes it at once.
         */
        post: operations["invite_approver"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/approver-history": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Approver Changes
         * @description Return the project's approvers, newest first.
         */
        get: operations["list_approver_changes"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/invitations": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Invitations
         * @description Return the project's invitations, but for those withdrawn.
         */
        get: operations["list_invitations"];
        put?: never;
        /**
         * Invite Designer
         * @description Mail a designer a link that shows the list; the answer does not reveal whether the address has an account.
         */
        post: operations["invite_designer"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/invitations/{invitation_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        post?: never;
        /**
         * Revoke Invitation
         * @description Withdraw an invitation: its link shows nothing any more.
         */
        delete: operations["revoke_invitation"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/engagements/{engagement_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        /**
         * Change Engagement
         * @description Change a designer's tie, end it or take it up again.
         */
        patch: operations["change_engagement"];
        trace?: never;
    };
    "/v1/projects/{project_id}/tokens": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Tokens
         * @description Return the keys of the project's builds, without their secrets.
         */
        get: operations["list_tokens"];
        put?: never;
        /**
         * Create Token
         * @description Make a key for the project's builds; its secret is shown this once.
         */
        post: operations["create_token"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/tokens/{token_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        post?: never;
        /**
         * Revoke Token
         * @description Revoke a token at once.
         */
        delete: operations["revoke_token"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/invitations/{secret}/accept": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Accept Invitation
         * @description Engage the invited designer with the address's account, made now if there is none, and sign in.
         */
        post: operations["accept_invitation"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/category-approvers": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /**
         * Name Category Approver
         * @description Give a category of the sound list an approver of its own, or give it back to the project's approver.
         */
        put: operations["name_category_approver"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/deputies": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Deputies
         * @description Return who may approve in place of whom, today and on later days.
         */
        get: operations["list_deputies"];
        put?: never;
        /**
         * Name Deputy
         * @description Let a member of the studio approve in place of another, from one day to another.
         */
        post: operations["name_deputy"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/deputies/{deputy_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        post?: never;
        /**
         * Withdraw Deputy
         * @description End the right of a deputy at once.
         */
        delete: operations["withdraw_deputy"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/spec": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Spec
         * @description Return the delivery spec that holds now.
         */
        get: operations["read_spec"];
        /**
         * Save Spec
         * @description Save the spec from its text; affected takes are checked again.
         */
        put: operations["save_spec"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/spec.toml": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Download Spec
         * @description Return the delivery spec as the file that audio-checks reads.
         */
        get: operations["download_spec"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/spec/versions": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Spec Versions
         * @description Return the versions of the spec, newest first.
         */
        get: operations["list_spec_versions"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/spec/versions/{version}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Spec Version
         * @description Return one version of the spec.
         */
        get: operations["read_spec_version"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/spec/form": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Save Spec Form
         * @description Save the spec from the tables of a form; affected takes are checked again.
         */
        post: operations["save_spec_form"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/spec/check-toml": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Check Spec Draft
         * @description Return the resolved spec of a text or a form's tables, and their errors; nothing is saved.
         */
        post: operations["check_spec_draft"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/brief": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Brief
         * @description Return the questions of the brief with their answers, and how complete they are.
         */
        get: operations["read_brief"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        /**
         * Change Brief
         * @description Save answers; two people collide only where both changed the same one.
         */
        patch: operations["change_brief"];
        trace?: never;
    };
    "/v1/projects/{project_id}/brief/versions": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Brief Versions
         * @description Return the published versions of the brief, newest first.
         */
        get: operations["list_brief_versions"];
        put?: never;
        /**
         * Publish Brief Version
         * @description Keep the answers as a version that never changes.
         */
        post: operations["publish_brief_version"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/brief/versions/{version}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Brief Version
         * @description Return one published version with its answers.
         */
        get: operations["read_brief_version"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/brief/versions/{version}/read": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /**
         * Record Brief Read
         * @description Record that the calling designer opened a version, which the team sees.
         */
        put: operations["record_brief_read"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/brief/reads": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Brief Reads
         * @description Return which version each engaged designer opened last.
         */
        get: operations["list_brief_reads"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/brief/compare": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Compare Brief Versions
         * @description Return the answers that differ between two versions; version 0 is the empty brief.
         */
        get: operations["compare_brief_versions"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/brief/spec": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Propose Spec
         * @description Return the delivery spec as the answers ask for it, and each difference to the one in force.
         */
        get: operations["propose_spec"];
        put?: never;
        /**
         * Apply Spec Proposal
         * @description Save what the answers ask for as a version of the delivery spec; affected takes are checked again.
         */
        post: operations["apply_spec_proposal"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/brief/follow-ups": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Ask Follow Up
         * @description Ask the team about a question of the brief.
         */
        post: operations["ask_follow_up"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/brief-follow-ups/{follow_up_id}/answer": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Answer Follow Up
         * @description Answer a designer's follow-up, once.
         */
        post: operations["answer_follow_up"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/clarity": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Check Clarity
         * @description Return the cues whose words leave something open, with a question for each fact; it blocks nothing.
         */
        get: operations["check_clarity"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/cues/{cue_id}/clarity/{fact}/answer": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Answer Fact
         * @description Write an answer into the cue's description.
         */
        post: operations["answer_fact"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/cues/{cue_id}/clarity/{fact}/dismissed": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /**
         * Dismiss Fact
         * @description Ask for a fact of a cue no more, or again.
         */
        put: operations["dismiss_fact"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/sound-list": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Sound List
         * @description Return one page of the project's cues in list order, cut ones too.
         */
        get: operations["get_sound_list"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/categories": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Categories
         * @description Return the categories of the list by name, with the number of their cues.
         */
        get: operations["list_categories"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/sound-list.csv": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Export Sound List
         * @description Return the list as the CSV that `audio-checks check --list` and spreadsheets read.
         */
        get: operations["export_sound_list"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/cues": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Add Cues
         * @description Add typed rows to the end of the list: all of them, or none.
         */
        post: operations["add_cues"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/cues/{cue_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Cue
         * @description Return one cue with what was asked about it.
         */
        get: operations["get_cue"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        /**
         * Change Cue
         * @description Change some facts of a cue; the edition that was read must still be the newest.
         */
        patch: operations["change_cue"];
        trace?: never;
    };
    "/v1/cues/{cue_id}/placeholder": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /**
         * Flag Placeholder
         * @description Set whether the game plays a placeholder file until the sound comes.
         */
        put: operations["flag_placeholder"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/cues/{cue_id}/palette": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /**
         * Flag Palette
         * @description Set whether the cue belongs to the palette that new sounds are compared with.
         */
        put: operations["flag_palette"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/cues/order": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Order Cues
         * @description Put cues in another order; those left out keep their places.
         */
        post: operations["order_cues"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/sound-list/import": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Import Sound List
         * @description Read a spreadsheet into the list; with an error in any row nothing is imported.
         */
        post: operations["import_sound_list"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/sound-list/revisions": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Revisions
         * @description Return the saved changes of the list, the newest first.
         */
        get: operations["list_revisions"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/sound-list/revisions/compare": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Compare Revisions
         * @description Return what was added, changed and cut between two revisions; `from=0` is the empty list.
         */
        get: operations["compare_revisions"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/questions": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Questions
         * @description Return the questions on the project's cues, the oldest first.
         */
        get: operations["list_questions"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/cues/{cue_id}/questions": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Ask Question
         * @description Ask the team what it means by a cue.
         */
        post: operations["ask_question"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/questions/{question_id}/answer": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Answer Question
         * @description Answer a question; the answer joins the cue's description unless the request says otherwise.
         */
        post: operations["answer_question"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/invitations/{secret}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Preview Invitation
         * @description Show what a mailed link invites to: the project and, unless an NDA comes first, its list and its spec.
         */
        get: operations["preview_invitation"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/sound-list/coverage": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Coverage
         * @description Return the scenes, categories and priority sounds that the brief names and the list lacks.
         */
        get: operations["read_coverage"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/kits": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Kits
         * @description Return the kinds of game that a list can be started from.
         */
        get: operations["list_kits"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/kits/{kit_key}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Kit
         * @description Return the cues of a kit under the names that the project's spec asks for; nothing is added.
         */
        get: operations["read_kit"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/cues/undo-addition": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Undo Cue Addition
         * @description Remove the cues that the newest revision added, while no work on them has begun.
         */
        post: operations["undo_cue_addition"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/postings": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Postings
         * @description Return the postings of a project, newest first.
         */
        get: operations["list_postings"];
        put?: never;
        /**
         * Create Posting
         * @description Begin a posting as a draft, its lines counted from the sound list.
         */
        post: operations["create_posting"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/postings": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List My Postings
         * @description Return the postings that the caller may bid on, newest first.
         */
        get: operations["list_my_postings"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/postings/{posting_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Posting
         * @description Return a posting: whole for those who act for the studio, as far as it concerns them for candidates.
         */
        get: operations["read_posting"];
        /**
         * Change Posting
         * @description Change a posting; what bids are made on is fixed once it is open.
         */
        put: operations["change_posting"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/postings/{posting_id}/open": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Open Posting
         * @description Take bids from now on, and mail those who were asked; a closed posting opens again.
         */
        post: operations["open_posting"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/postings/{posting_id}/close": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Close Posting
         * @description Take no more bids.
         */
        post: operations["close_posting"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/postings/{posting_id}/candidates": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Invite Candidate
         * @description Ask a person for a bid: by mail at once, or when the posting opens.
         */
        post: operations["invite_candidate"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/postings/{posting_id}/candidates/{candidate_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        post?: never;
        /**
         * Withdraw Candidate
         * @description Take a person off the posting.
         */
        delete: operations["withdraw_candidate"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/postings/{posting_id}/link": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Make Posting Link
         * @description Make a link that shows the posting without an invitation; an earlier one stops working.
         */
        post: operations["make_posting_link"];
        /**
         * Revoke Posting Link
         * @description Withdraw the link; who came by it stays.
         */
        delete: operations["revoke_posting_link"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/posting-links/{secret}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Preview Posting
         * @description Show a posting to everyone who has its link: all of it, or title, dates and studio while an NDA comes first.
         */
        get: operations["preview_posting"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/posting-links/{secret}/join": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Join Posting
         * @description Let the caller bid on the posting behind a link.
         */
        post: operations["join_posting"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/posting-links/{secret}/ask": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Ask For Posting Link
         * @description Mail a link of one's own, by which a person makes an account and bids; the same answer for every address.
         */
        post: operations["ask_for_posting_link"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/posting-links/{secret}/account": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Open Account By Posting Link
         * @description Sign in as the person whose personal link it is, with an account made now if the address has none.
         */
        post: operations["open_account_by_posting_link"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/postings/{posting_id}/bid": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /**
         * Save Bid
         * @description Keep a bid as it is typed; the studio does not see it until it is sent.
         */
        put: operations["save_bid"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/postings/{posting_id}/bid/send": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Send Bid
         * @description Show the studio the bid as it was read; sending again replaces what was sent.
         */
        post: operations["send_bid"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/postings/{posting_id}/bid/withdraw": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Withdraw Bid
         * @description Take a bid back; the draft is kept.
         */
        post: operations["withdraw_bid"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/postings/{posting_id}/questions": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Ask About Posting
         * @description Ask the studio about a posting.
         */
        post: operations["ask_about_posting"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/posting-questions/{posting_question_id}/answer": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Answer Posting Question
         * @description Answer a question once, for all candidates or for the one who asked.
         */
        post: operations["answer_posting_question"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/postings/{posting_id}/bids": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Compare Bids
         * @description Return the bids side by side: those shortlisted first, then the first sent first.
         */
        get: operations["compare_bids"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/bids/{bid_id}/shortlist": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /**
         * Shortlist Bid
         * @description Put a bid on the shortlist, or take it off.
         */
        put: operations["shortlist_bid"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/bids/{bid_id}/scores": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /**
         * Score Bid
         * @description Keep the caller's scores of a bid; the others' are shown once each heading has one.
         */
        put: operations["score_bid"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/bids/{bid_id}/award": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Award Posting
         * @description Award a posting to a bid: its designer is engaged, a draft contract is opened, and the others are thanked.
         */
        post: operations["award_posting"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/milestones": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Plan
         * @description Return the milestones of a contract with what became of them, and what is unwise about the plan.
         */
        get: operations["read_plan"];
        /**
         * Save Plan
         * @description Put a plan in the place of a draft's; what is unwise about it is said, and does not stop it.
         */
        put: operations["save_plan"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/milestones/proposal": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Propose Plan
         * @description Return milestones by the due dates and categories of the sound list, to begin a plan from; nothing is saved.
         */
        get: operations["propose_plan"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/plan-check": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Check Plan
         * @description Return what is wrong with a plan, and what is unwise about it and why; nothing is saved.
         */
        post: operations["check_plan"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/shipped": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Say Game Shipped
         * @description Say that the game has shipped, which makes the bonus due that waits for it.
         */
        post: operations["say_game_shipped"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/ledger": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Ledger
         * @description Return a contract's ledger line by line, and what it comes to.
         */
        get: operations["read_ledger"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/extra-rounds": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Extra Rounds
         * @description Return the rounds beyond the included ones, with their prices.
         */
        get: operations["read_extra_rounds"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/extra-rounds/{extra_round_id}/agree": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Agree Extra Round
         * @description Agree to the price of a further round; it is due at once.
         */
        post: operations["agree_extra_round"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/extra-rounds/{extra_round_id}/drop": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Drop Extra Round
         * @description Let a further round go without its price.
         */
        post: operations["drop_extra_round"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/invoice-draft": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Invoice Draft
         * @description Return what an invoice would say if it were issued now, under this number or the one after the last.
         */
        get: operations["read_invoice_draft"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/invoices": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Invoices
         * @description Return the invoices of a contract, the oldest first.
         */
        get: operations["list_invoices"];
        put?: never;
        /**
         * Issue Invoice
         * @description Issue an invoice over everything that is due and on none yet.
         */
        post: operations["issue_invoice"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/invoices/{invoice_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Invoice
         * @description Return an invoice with its lines and payments.
         */
        get: operations["read_invoice"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/invoices/{invoice_id}/invoice.pdf": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Invoice Pdf
         * @description Return an invoice as PDF; the same invoice is the same bytes.
         */
        get: operations["read_invoice_pdf"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/invoices/{invoice_id}/late-interest": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Charge Late Interest
         * @description Make the interest that an invoice bears by today due; it goes on the next invoice.
         */
        post: operations["charge_late_interest"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/invoices/{invoice_id}/payments": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Record Payment
         * @description Record what was paid on an invoice, in part or whole.
         */
        post: operations["record_payment"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/payments/{payment_id}/refunds": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Refund Payment
         * @description Record that a payment went back, in part or whole.
         */
        post: operations["refund_payment"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/cues/{cue_id}/money": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Cue Money
         * @description Return what accepting a cue would make due, and its rounds; null where no contract covers it.
         */
        get: operations["read_cue_money"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/estimates": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Estimates
         * @description Return estimates against actual values; for the two parties only.
         */
        get: operations["read_estimates"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/work-logs": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Log Work
         * @description Note time that went into a cue.
         */
        post: operations["log_work"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/worked-days": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Worked Days
         * @description Return the days that were logged under a contract by the day.
         */
        get: operations["list_worked_days"];
        put?: never;
        /**
         * Log Day
         * @description Log a day, or quarters of one; logged again, it is corrected.
         */
        post: operations["log_day"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/worked-days/{worked_day_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        post?: never;
        /**
         * Drop Day
         * @description Take a logged day back, until the studio agrees to it.
         */
        delete: operations["drop_day"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/worked-days/{worked_day_id}/agree": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Agree Day
         * @description Agree to a logged day; it is due, up to the cap.
         */
        post: operations["agree_day"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/calendar": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Make Calendar
         * @description Make the secret address of the caller's calendar; an earlier one loses its worth.
         */
        post: operations["make_calendar"];
        /**
         * Withdraw Calendar
         * @description Revoke the addresses of the caller's calendar.
         */
        delete: operations["withdraw_calendar"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/calendars/{secret}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Calendar
         * @description Return the dates of contracts as iCalendar, for the holder of the address.
         */
        get: operations["read_calendar"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contract-library/{kind}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Contract Library
         * @description Return the clauses that the library has for a kind of contract, and what they leave open.
         */
        get: operations["read_contract_library"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contract-library/{kind}/template.toml": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Download Library Template
         * @description Return what the library has for a kind as a template file.
         */
        get: operations["download_library_template"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/studios/{studio_id}/contract-templates": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Contract Templates
         * @description Return the templates that a studio keeps, by name.
         */
        get: operations["list_contract_templates"];
        put?: never;
        /**
         * Add Contract Template
         * @description Keep a template.
         */
        post: operations["add_contract_template"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/studios/{studio_id}/contract-templates/import": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Import Contract Template
         * @description Keep a template that comes as TOML.
         */
        post: operations["import_contract_template"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/studios/{studio_id}/contract-templates/{template_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Contract Template
         * @description Return a template with its clauses.
         */
        get: operations["read_contract_template"];
        /**
         * Change Contract Template
         * @description Change a template; contracts that began from it stay as they are.
         */
        put: operations["change_contract_template"];
        post?: never;
        /**
         * Drop Contract Template
         * @description Keep a template no longer.
         */
        delete: operations["drop_contract_template"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/studios/{studio_id}/contract-templates/{template_id}/template.toml": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Download Contract Template
         * @description Return a template as the file that an import reads.
         */
        get: operations["download_contract_template"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/studios/{studio_id}/contract-templates/{template_id}/template.md": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Download Contract Template Text
         * @description Return a template's standing clauses as Markdown, for lawyers to read.
         */
        get: operations["download_contract_template_text"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/template": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Save Contract As Template
         * @description Keep the contract's clauses and terms as a template of the studio.
         */
        post: operations["save_contract_as_template"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/contracts": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Contracts
         * @description Return the project's contracts, the oldest first; a designer sees their own, once they were sent.
         */
        get: operations["list_contracts"];
        put?: never;
        /**
         * Create Contract
         * @description Begin a draft with one designer, from the library or a template of the studio.
         */
        post: operations["create_contract"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/last-contract": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Last Contract
         * @description Return the contract that a new one can begin like: the last with this designer, else the studio's last.
         */
        get: operations["read_last_contract"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Contract
         * @description Return a contract with its newest text; the designer reads what was sent.
         */
        get: operations["read_contract"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/draft": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /**
         * Save Contract Draft
         * @description Save the draft as its next version.
         */
        put: operations["save_contract_draft"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/preview": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Preview Contract
         * @description Return the text that a draft would have; nothing is saved.
         */
        post: operations["preview_contract"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/send": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Send Contract
         * @description Put the text before both parties as PDF, with the open questions of this moment.
         */
        post: operations["send_contract"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/recall": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Recall Contract
         * @description Make a sent contract a draft again.
         */
        post: operations["recall_contract"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/ask-change": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Request Contract Change
         * @description Send a contract back to the studio with what its designer wants otherwise.
         */
        post: operations["request_contract_change"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/signers": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /**
         * Set Contract Signers
         * @description Name the producers who sign a draft for the studio, in order, and which party signs first.
         */
        put: operations["set_contract_signers"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/accept": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Accept Contract
         * @description Sign the text that was sent, for the caller's party; once all have signed, it is agreed.
         */
        post: operations["accept_contract"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/end": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * End Contract
         * @description End a contract that orders no work, or give up a draft.
         */
        post: operations["end_contract"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/signing-codes": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Request Signing Code
         * @description Mail the caller a code to sign a text of a contract with: the contract's own, a change order's, a statement's.
         */
        post: operations["request_signing_code"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/versions": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Contract Versions
         * @description Return the versions that the caller may see, the newest first.
         */
        get: operations["list_contract_versions"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/versions/{version}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Contract Version
         * @description Return one version of the text.
         */
        get: operations["read_contract_version"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/versions/{version}/contract.pdf": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Download Contract Pdf
         * @description Return the PDF of a version that was sent: sealed once all have signed it, or else as both saw it.
         */
        get: operations["download_contract_pdf"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/versions/{version}/contract.docx": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Download Contract Docx
         * @description Return a version as a Word document, with tracked changes against another one if one is named.
         */
        get: operations["download_contract_docx"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/comparison": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Compare Contract Versions
         * @description Return two versions word by word.
         */
        get: operations["compare_contract_versions"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/record": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Contract Record
         * @description Return the record of a contract, verified now.
         */
        get: operations["read_contract_record"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/record.json": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Download Contract Record
         * @description Return the record as the file that a party keeps, and that `soundlist verify` reads.
         */
        get: operations["download_contract_record"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/head.json": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Download Contract Head
         * @description Return the head of the record, signed: what a party keeps, and `soundlist verify --head` reads.
         */
        get: operations["download_contract_head"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/redlines": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Redlines
         * @description Return a round of redlines in the text that it is about, with the answers so far; the last one by default.
         */
        get: operations["read_redlines"];
        put?: never;
        /**
         * Propose Redlines
         * @description Send a contract back to the studio with changes of its clauses.
         */
        post: operations["propose_redlines"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/redline-preview": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Preview Redlines
         * @description Return the text as changes would mark it; nothing is saved.
         */
        post: operations["preview_redlines"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/redlines/{redline_number}/answer": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Answer Redline
         * @description Accept, refuse or counter a redline; the last answer before the next version is sent counts.
         */
        post: operations["answer_redline"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/verify": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Verify Pdf
         * @description Say of a PDF whether it is a contract that was signed and sealed here, and whether it is untouched.
         *
         *     An untouched one says what it binds. A file that was changed, or is not from here, says nothing of any contract.
         */
        post: operations["verify_pdf"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/ending": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Ending
         * @description Return what a contract comes to if it ends early: a forecast, the statement of a notice, or what was settled.
         */
        get: operations["read_ending"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/ending/notice": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Give Notice
         * @description Give notice for the caller's party.
         */
        post: operations["give_notice"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/ending/withdraw": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Withdraw Notice
         * @description Take a notice back, as the party that gave it.
         */
        post: operations["withdraw_notice"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/ending/agree": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Agree To Statement
         * @description Say yes to the statement for the caller's party; with the second yes the contract is settled and ends.
         */
        post: operations["agree_to_statement"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/ending/statement.pdf": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Download Statement
         * @description Return the statement as PDF; the same text is the same bytes.
         */
        get: operations["download_statement"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/change-orders": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Change Orders
         * @description Return the change orders of a contract, the oldest first, and what one may name.
         */
        get: operations["list_change_orders"];
        put?: never;
        /**
         * Propose Change Order
         * @description Propose a change order for the caller's party.
         */
        post: operations["propose_change_order"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/change-order-preview": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Preview Change Order
         * @description Return what changes would do to scope, price and dates; nothing is saved.
         */
        post: operations["preview_change_order"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/change-offers/dismiss": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Dismiss Change Offer
         * @description Dismiss an offered change order for the caller's party; the record keeps the reason.
         */
        post: operations["dismiss_change_offer"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/change-orders/{change_order_number}/accept": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Accept Change Order
         * @description Say yes to a change order for the caller's party; with the second yes it is in force.
         */
        post: operations["accept_change_order"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/change-orders/{change_order_number}/refuse": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Refuse Change Order
         * @description Refuse a change order that the other party proposed.
         */
        post: operations["refuse_change_order"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/change-orders/{change_order_number}/withdraw": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Withdraw Change Order
         * @description Take back a change order that the caller's party proposed.
         */
        post: operations["withdraw_change_order"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/change-orders/{change_order_number}/change-order.pdf": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Download Change Order
         * @description Return a change order as PDF; the same text is the same bytes.
         */
        get: operations["download_change_order"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/uploads": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /**
         * Put Upload
         * @description Take a whole file in one request: all of it, or nothing.
         */
        put: operations["put_upload"];
        /**
         * Begin Upload
         * @description Make room for a file in a delivery; bytes may come along.
         */
        post: operations["begin_upload"];
        delete?: never;
        /**
         * Describe Uploads
         * @description Return the tus extensions of this server, and whether its store accepts parts.
         */
        options: operations["describe_uploads"];
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/uploads/{upload_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        post?: never;
        /**
         * Cancel Upload
         * @description Delete an unfinished upload.
         */
        delete: operations["cancel_upload"];
        options?: never;
        /**
         * See Upload
         * @description Return the offset of an upload.
         */
        head: operations["see_upload"];
        /**
         * Continue Upload
         * @description Append bytes to an upload, and answer once they are on the disk.
         */
        patch: operations["continue_upload"];
        trace?: never;
    };
    "/v1/uploads/{upload_id}/parts": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Request Parts
         * @description Return the parts of a file in the store, and signed links for others.
         */
        post: operations["request_parts"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/uploads/{upload_id}/finish": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Finish Parts
         * @description Finish a file whose parts are all in the store: it is read and hashed there, whatever its sender claims.
         */
        post: operations["finish_parts"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/takes/accept-sure": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Accept Sure Matches
         * @description Match the files of the tray whose names are sure; a designer's own. Guesses stay where they are.
         */
        post: operations["accept_sure_matches"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/takes/move": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Move Takes
         * @description Move takes to other cues or variations, all or none, before any verdict; each is checked again there.
         */
        post: operations["move_takes"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/takes/rename-preview": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Preview Renames
         * @description Show what takes would be called after a move; nothing is changed.
         */
        post: operations["preview_renames"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/takes/discard": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Discard Takes
         * @description Take files out of the list and the tray, all or none, before any verdict; their masters are kept.
         */
        post: operations["discard_takes"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/takes/restore": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Restore Takes
         * @description Put discarded takes back into the tray.
         */
        post: operations["restore_takes"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/tray-actions/{tray_action_id}/undo": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Undo Tray Action
         * @description Put takes back where they were before an action; those that were touched since stay.
         */
        post: operations["undo_tray_action"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/deliveries/{delivery_id}/files": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Add File
         * @description Deliver a file of at most 8 MiB in one request; the same bytes again are the same take.
         */
        post: operations["add_file"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/deliveries/{delivery_id}/sources": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * See Delivery Sources
         * @description Show what a delivery was made from; its designer also sees what they stated last.
         */
        get: operations["see_delivery_sources"];
        /**
         * State Delivery Sources
         * @description State what the takes of a delivery were made from; a take can have a statement of its own.
         */
        put: operations["state_delivery_sources"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/takes/{take_id}/sources": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * See Take Sources
         * @description Show what a take was made from.
         */
        get: operations["see_take_sources"];
        /**
         * State Take Sources
         * @description State what one take was made from; once it is approved and nothing is open, that stands.
         */
        put: operations["state_take_sources"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/deliveries": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Deliveries
         * @description List deliveries, the newest first; a designer's own.
         */
        get: operations["list_deliveries"];
        put?: never;
        /**
         * Open Delivery
         * @description Open a delivery to upload into.
         */
        post: operations["open_delivery"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/deliveries/{delivery_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * See Delivery
         * @description Show a delivery with its takes, dry stems and ZIPs.
         */
        get: operations["see_delivery"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        /**
         * Change Delivery
         * @description Change a delivery's note.
         */
        patch: operations["change_delivery"];
        trace?: never;
    };
    "/v1/deliveries/{delivery_id}/close": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Close Delivery
         * @description Close a delivery.
         */
        post: operations["close_delivery"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/deliveries/{delivery_id}/takes": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Add Take
         * @description Turn a finished upload into a take and queue its check; the same upload again is the same take.
         */
        post: operations["add_take"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/deliveries/{delivery_id}/archives": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Add Archive
         * @description Keep a finished upload as a ZIP and queue its unpacking; each file in it becomes a take.
         */
        post: operations["add_archive"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/takes": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Takes
         * @description List takes, the newest first; a designer's own. `unmatched=true` is the tray.
         */
        get: operations["list_takes"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/takes/{take_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * See Take
         * @description Show one take.
         */
        get: operations["see_take"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/takes/{take_id}/match": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /**
         * Match Take
         * @description Match a take to a cue; it is checked again as that cue.
         */
        put: operations["match_take"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/takes/{take_id}/master": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Download Master
         * @description Give a take's master exactly as it was delivered; ranges may be asked for.
         */
        get: operations["download_master"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/takes/{take_id}/dry-stem": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Download Dry Stem
         * @description Give a take's dry stem exactly as it was delivered; ranges may be asked for.
         */
        get: operations["download_dry_stem"];
        /**
         * Add Dry Stem To Take
         * @description Add a take's dry stem; the take's reverb is then measured against it.
         */
        put: operations["add_dry_stem_to_take"];
        post?: never;
        /**
         * Withdraw Dry Stem
         * @description Withdraw a take's dry stem; the take is judged without it again.
         */
        delete: operations["withdraw_dry_stem"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/checks": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Checks
         * @description List the checks of this server in the order of reports: how forms show them, and what a spec may state.
         */
        get: operations["list_checks"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/takes/{take_id}/check": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * See Check
         * @description Return the newest check of a take.
         */
        get: operations["see_check"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/takes/{take_id}/waiver": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Waive Findings
         * @description Let a returned take through with its findings, for a reason.
         */
        post: operations["waive_findings"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/takes/{take_id}/recheck": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Recheck Take
         * @description Have a take that is not decided upon checked again.
         */
        post: operations["recheck_take"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/fixes": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Fixes
         * @description List the takes of which a fix would be enough, longest waiting first; a designer's own.
         */
        get: operations["list_fixes"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/takes/{take_id}/fix": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * See Fix
         * @description Show what a fix can do, or did, about a take.
         */
        get: operations["see_fix"];
        put?: never;
        /**
         * Request Fix
         * @description Request a fixed copy, to see and play before it is used.
         */
        post: operations["request_fix"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/takes/{take_id}/fix/use": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Use Fix
         * @description Make the fixed copy a new version, with the consent of its designer; no round counts.
         */
        post: operations["use_fix"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/takes/{take_id}/sounds": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Take Sounds
         * @description Return a take's master and its game files at the current spec, with what is needed to show and play them.
         */
        get: operations["get_take_sounds"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/sounds/{picture_id}/preview": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Preview
         * @description Play a sound: at most 48 kHz, 16 bit, in a form that every browser plays; parts of it by Range.
         */
        get: operations["get_preview"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/sounds/{picture_id}/peaks.json": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Peaks
         * @description Return the shape of a sound across a screen.
         */
        get: operations["get_peaks"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/sounds/{picture_id}/spectrum.png": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Spectrum
         * @description Return the spectrum over time: 20 kHz at the top, 60 Hz at the bottom, white is loudest, 72 dB to black.
         */
        get: operations["get_spectrum"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/renders/{render_id}/file": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Render File
         * @description Download a game file under the name that the game expects.
         */
        get: operations["get_render_file"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/renders/{render_id}/loss": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Render Loss
         * @description Return what a game file lost against its master, in figures and in both spectra.
         */
        get: operations["get_render_loss"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/batches": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Batches
         * @description Return the project's batches of game files, the newest first.
         */
        get: operations["list_batches"];
        put?: never;
        /**
         * Add Batch
         * @description Render every game file of the project again, or those of some targets; earlier files are kept.
         */
        post: operations["add_batch"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/batches/{batch_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Batch
         * @description Return how far a batch is, and what it does to the sizes.
         */
        get: operations["get_batch"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/batches/{batch_id}/cancel": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Cancel Batch
         * @description End a batch that is not through; what it has made stays.
         */
        post: operations["cancel_batch"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/cues/{cue_id}/reels": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Add Reel
         * @description Put all takes of a cue that the caller sees in a row, to be listened to; the same takes give the same reel.
         */
        post: operations["add_reel"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/reels/{reel_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Reel
         * @description Return whether a reel is made, and where each take begins in it.
         */
        get: operations["get_reel"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/reels/{reel_id}/file": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Reel File
         * @description Play or download a reel: 16-bit WAV, which never ships.
         */
        get: operations["get_reel_file"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/takes/{take_id}/master-exports": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Add Master Export
         * @description Have a take's master copied with what is known of it written into it; the master stays as it was delivered.
         */
        post: operations["add_master_export"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/master-exports/{master_export_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Master Export
         * @description Return the state of a master with its provenance, and its metadata.
         */
        get: operations["get_master_export"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/master-exports/{master_export_id}/file": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Master Export File
         * @description Download a master with its provenance, in bext and in iXML with the fields of ASWG-G006.
         */
        get: operations["get_master_export_file"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/review-queue": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Review Queue
         * @description Return what waits for review, oldest first: of one project, or of all projects of the caller's studios.
         */
        get: operations["get_review_queue"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/review-queue/count": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Count Review Queue
         * @description Count the cues that wait for review, up to 99: of one project, or of all projects of the caller's studios.
         */
        get: operations["count_review_queue"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/cues/{cue_id}/review": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Cue Review
         * @description Return everything of one cue that the review room shows, takes in every state included.
         */
        get: operations["get_cue_review"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/takes/{take_id}/verdict": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Give Verdict
         * @description Approve a take, set it aside, or note a change as a draft.
         */
        post: operations["give_verdict"];
        /**
         * Undo Verdict
         * @description Take back what the last click on a take decided, a whole accepted set included, within a minute.
         */
        delete: operations["undo_verdict"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/cues/{cue_id}/accept-set": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Accept Set
         * @description Approve one take of every variation at once, or none where a variation lacks one.
         */
        post: operations["accept_set"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/change-requests": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Change Requests
         * @description Return drafts (the team's alone) or sent change requests, newest first.
         */
        get: operations["list_change_requests"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/change-requests/{change_request_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        post?: never;
        /**
         * Drop Change Request
         * @description Drop a draft.
         */
        delete: operations["drop_change_request"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/feedback": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Send Change Requests
         * @description Send all drafts together; one sending counts one round for each cue or set it names.
         */
        post: operations["send_change_requests"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/takes/{take_id}/comments": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Comments
         * @description Return the advice on a take, oldest first.
         */
        get: operations["list_comments"];
        put?: never;
        /**
         * Add Comment
         * @description Write advice on a take, at a time in the sound or on the whole of it, or a reply to what was said of it.
         */
        post: operations["add_comment"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/comments/{comment_id}/resolve": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Resolve Comment
         * @description Mark advice as seen to.
         */
        post: operations["resolve_comment"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/takes/{take_id}/carried-notes/{note_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Answer Carried Note
         * @description Say whether a version does what a comment or a change request on an earlier one asked.
         */
        post: operations["answer_carried_note"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/takes/{take_id}/history": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Take History
         * @description Return what happened to a take, oldest first.
         */
        get: operations["get_take_history"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/cues/{cue_id}/cut": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Cut Cue
         * @description Cut a cue that the game no longer needs; it is kept with its reason and its takes.
         */
        post: operations["cut_cue"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/takes/{take_id}/fit": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * See Take Fit
         * @description Compare a take with the approved sounds of its category, or of the palette.
         */
        get: operations["see_take_fit"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/deliveries/{delivery_id}/fit": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * See Delivery Fit
         * @description Compare a delivery with other designers' approved sounds.
         */
        get: operations["see_delivery_fit"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/pack": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Pack
         * @description Return the content of the approved pack of a target, and what is missing.
         */
        get: operations["get_pack"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/pack.zip": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Download Pack
         * @description Stream the approved pack; an answer shorter than its Content-Length is a broken one.
         */
        get: operations["download_pack"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/documentation-key.csv": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Documentation Key Csv
         * @description Return what each file of the pack is and what it is for, as CSV.
         */
        get: operations["get_documentation_key_csv"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/documentation-key.xlsx": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Documentation Key Xlsx
         * @description Return what each file of the pack is and what it is for, as a workbook.
         */
        get: operations["get_documentation_key_xlsx"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/documentation-key.pdf": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Documentation Key Pdf
         * @description Return what each file of the pack is and what it is for, to read and to print.
         */
        get: operations["get_documentation_key_pdf"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/targets": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Targets
         * @description Return what game files are made to, what they take in memory, and what the whole list will take.
         */
        get: operations["get_targets"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/placeholders": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Placeholders
         * @description Return what the game has no accepted sound for yet, and which of it has a placeholder file.
         */
        get: operations["get_placeholders"];
        put?: never;
        /**
         * Make Placeholders
         * @description Have a placeholder file made for everything that a target's pack lacks: to spec, by name, and marked.
         */
        post: operations["make_placeholders"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/placeholders/countdown": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Placeholders Countdown
         * @description Return how much is still a placeholder, by category, and what to record next.
         */
        get: operations["get_placeholders_countdown"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/packs": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Packs
         * @description Return the packs that were handed out, the newest first.
         */
        get: operations["list_packs"];
        put?: never;
        /**
         * Add Pack
         * @description Seal what is accepted now as a numbered pack, which never changes; the worker puts it together.
         */
        post: operations["add_pack"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/packs/{pack_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Sealed Pack
         * @description Return a pack that was handed out, and what is not as it was in the one before.
         */
        get: operations["get_sealed_pack"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/packs/{pack_id}/pack.zip": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Download Sealed Pack
         * @description Stream a pack that was handed out, the same bytes each time.
         */
        get: operations["download_sealed_pack"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/builds": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Builds
         * @description Return the project's builds, the newest first.
         */
        get: operations["list_builds"];
        put?: never;
        /**
         * Post Build
         * @description Store the report of audio-checks on one build of the game.
         */
        post: operations["post_build"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/builds/{build_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Build
         * @description Return one build with its whole report.
         */
        get: operations["get_build"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/baseline.json": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Baseline
         * @description Return what the approver let through, for `audio-checks check --baseline`.
         */
        get: operations["get_baseline"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/ci": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Ci Lines
         * @description Return the shell lines by which the game's CI checks its audio and posts the report.
         */
        get: operations["get_ci_lines"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/clearance-sheet.xlsx": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Clearance Sheet Xlsx
         * @description Return who made each sound of the pack, from what and under which contract, as a workbook.
         */
        get: operations["get_clearance_sheet_xlsx"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/clearance-sheet.pdf": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Clearance Sheet Pdf
         * @description Return who made each sound of the pack, from what and under which contract, to read and to print.
         */
        get: operations["get_clearance_sheet_pdf"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/packs/{pack_id}/clearance-sheet.xlsx": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Pack Clearance Sheet Xlsx
         * @description Return the clearance sheet of a sealed pack as a workbook.
         */
        get: operations["get_pack_clearance_sheet_xlsx"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/packs/{pack_id}/clearance-sheet.pdf": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Pack Clearance Sheet Pdf
         * @description Return the clearance sheet of a sealed pack, to read and to print.
         */
        get: operations["get_pack_clearance_sheet_pdf"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/contracts/{contract_id}/handover": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Download Handover
         * @description Stream what the next designer needs of a contract that has ended: approved masters, cues, brief, open rounds.
         */
        get: operations["download_handover"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/manifest.json": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Manifest
         * @description Return fingerprints of the approved pack's files, for `audio-checks audit`; 409 until all are computed.
         *
         *     It is empty if nothing is accepted. It includes accepted placeholder files: the audit reports them as such.
         */
        get: operations["get_manifest"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/packs/{pack_id}/manifest.json": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Sealed Manifest
         * @description Return what the game files of a pack that was handed out are known by, for `audio-checks audit`.
         */
        get: operations["get_sealed_manifest"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/game-files": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Game Files
         * @description Return every approved game file of a target with its hash, and what the game still lacks.
         */
        get: operations["list_game_files"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/game-files/origins": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Game File Origins
         * @description Return cue, approval, contract and sources of the game files of a name; an empty list where none has it.
         */
        get: operations["list_game_file_origins"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/soundlist.pyz": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Client Program
         * @description Return `soundlist pull` and `soundlist why` as one file, to be run by Python 3.11 or newer.
         */
        get: operations["get_client_program"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/game-files/{render_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Get Game File
         * @description Download an approved game file, or parts of it by Range.
         */
        get: operations["get_game_file"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/sound-list/progress": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read List Progress
         * @description Return the state of the cues of one page of the list; a designer sees their own takes only.
         *
         *     Pages and cursors are those of the sound list itself.
         */
        get: operations["read_list_progress"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/sound-list/counts": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read List Counts
         * @description Return the numbers of cues by state, of the whole list; a designer's view is of their own takes.
         */
        get: operations["read_list_counts"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/judged-lately": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Recent Verdicts
         * @description Return the cues that were decided upon within a week, the newest first.
         */
        get: operations["read_recent_verdicts"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/today": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Today
         * @description Return what waits for the team today, besides the review queue.
         */
        get: operations["read_today"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/next-steps": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Next Steps
         * @description Return what the caller is to do in a project, the first thing first, and for whom they wait.
         */
        get: operations["read_next_steps"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/pace": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Pace
         * @description Return how a project goes: the work's pace beside the studio's own, for both parties.
         */
        get: operations["read_pace"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/desk": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Desk
         * @description Return a designer's work in one project: how much of everything, and the first page of each list.
         */
        get: operations["read_desk"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/desk/came-back": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Came Back
         * @description Return the takes that are with the designer again, by cue, those that wait longest first.
         */
        get: operations["list_came_back"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/desk/to-make": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List To Make
         * @description Return the cues that wait for a file from the designer, in list order.
         */
        get: operations["list_to_make"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/desk/with-approver": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List With Approver
         * @description Return the designer's cues that wait for their verdict, in list order.
         */
        get: operations["list_with_approver"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/overview": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Overview
         * @description Return a project at one glance.
         */
        get: operations["read_overview"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/money": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Project Money
         * @description Return the money of a project; a designer sees that of their own contracts.
         */
        get: operations["read_project_money"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/milestones/{milestone_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Milestone
         * @description Return a milestone with its cues, how late it is, its estimates and its money.
         */
        get: operations["read_milestone"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/projects/{project_id}/find": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Find
         * @description Return what holds the typed words: cues first, then files, people, contracts, comments and questions.
         */
        get: operations["find"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/events": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Watch Changes
         * @description Send at once which rooms of the caller's projects changed, and nothing of what changed in them.
         */
        get: operations["watch_changes"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/studios/{studio_id}/outbox": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Outbox
         * @description Return the studio's mails, those that wait for an SMTP server first.
         */
        get: operations["read_outbox"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/mails/{mail_id}/send": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Send Mail Again
         * @description Try a mail again that was not sent.
         */
        post: operations["send_mail_again"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/studios/{studio_id}/operations": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Studio Operations
         * @description Return how many of the studio's jobs wait, run or failed, and whether a worker is running.
         */
        get: operations["read_studio_operations"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/studios/{studio_id}/storage": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Studio Storage
         * @description Return what the studio keeps.
         */
        get: operations["read_studio_storage"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/studios/{studio_id}/jobs": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Studio Jobs
         * @description Return the studio's jobs that wait, run or gave up, the oldest first.
         */
        get: operations["list_studio_jobs"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/studios/{studio_id}/jobs/{job_id}/retry": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Retry Studio Job
         * @description Let a job of the studio run again that gave up.
         */
        post: operations["retry_studio_job"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/operations": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Operations
         * @description Return the whole server's jobs and workers.
         */
        get: operations["read_operations"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/studios/{studio_id}/quotas": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Studio Quotas
         * @description Return what a studio uses of its limits.
         */
        get: operations["read_studio_quotas"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/operations/quotas": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Quotas
         * @description Return what every studio uses of its limits, the nearest to one first.
         */
        get: operations["read_quotas"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/operations/storage": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Storage
         * @description Return what every studio keeps.
         */
        get: operations["read_storage"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/operations/jobs": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Jobs
         * @description Return every job that waits, runs or gave up, the oldest first.
         */
        get: operations["list_jobs"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/operations/jobs/{job_id}/retry": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Retry Job
         * @description Let any job run again that gave up.
         */
        post: operations["retry_job"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
}
export type webhooks = Record<string, never>;
export interface components {
    schemas: {
        /**
         * AcceptAdd
         * @description A yes: under which name, and to which text.
         */
        AcceptAdd: {
            /** Name */
            name: string;
            /** Text Sha256 */
            text_sha256: string;
            /**
             * Code
             * @description The digits mailed to the caller; needed where the server sends mail.
             */
            code?: string | null;
        };
        /**
         * AcceptRead
         * @description The accepted formats of delivered files; null accepts anything that can be read.
         */
        AcceptRead: {
            /** Containers */
            containers: string[] | null;
            /** Encodings */
            encodings: string[] | null;
            /** Sample Rates Hz */
            sample_rates_hz: number[] | null;
            /** Bit Depths */
            bit_depths: number[] | null;
            /** Channels */
            channels: number[] | null;
            /** Layouts */
            layouts: string[] | null;
            duration_s: components["schemas"]["RangeRead"];
        };
        /**
         * AcceptanceRead
         * @description One person's yes, for a party.
         */
        AcceptanceRead: {
            party: components["schemas"]["Party"];
            /** Name */
            name: string;
            /** Email */
            email: string;
            /** @description How it was shown that they read the mail of that address; null: it was not. */
            email_proof: components["schemas"]["AddressProof"] | null;
            /**
             * Agent
             * @description Browser and system, as the browser names them; empty if unknown.
             */
            agent: string;
            /**
             * Code Entered At
             * @description When the code mailed to that address was typed; null: never.
             */
            code_entered_at: string | null;
            /**
             * Accepted At
             * Format: date-time
             */
            accepted_at: string;
        };
        /**
         * Activity
         * @description Something that happened lately.
         */
        Activity: {
            /**
             * At
             * Format: date-time
             */
            at: string;
            /**
             * Kind
             * @enum {string}
             */
            kind: "delivery" | "build" | "returned" | "approved" | "changes" | "cut" | "question" | "answer";
            /** Who */
            who: string;
            /** Text */
            text: string;
        };
        /**
         * AddCue
         * @description A cue that the contract covers from now on.
         */
        AddCue: {
            /**
             * @description discriminator enum property added by openapi-typescript
             * @enum {string}
             */
            kind: "add_cue";
            /**
             * Cue Id
             * Format: uuid
             */
            cue_id: string;
            /**
             * Milestone Id
             * Format: uuid
             */
            milestone_id: string;
            /** Price Minor */
            price_minor: number;
            /** Estimate Min */
            estimate_min?: number | null;
        };
        /**
         * AddRound
         * @description A round beyond those included, by the part of the cue's price that the contract names.
         */
        AddRound: {
            /**
             * @description discriminator enum property added by openapi-typescript
             * @enum {string}
             */
            kind: "add_round";
            /**
             * Cue Id
             * Format: uuid
             */
            cue_id: string;
        };
        /**
         * AddWork
         * @description Work beside the cues at a price, due when both have agreed: rush, a voice session, a new target.
         */
        AddWork: {
            /**
             * @description discriminator enum property added by openapi-typescript
             * @enum {string}
             */
            kind: "add_work";
            /**
             * Milestone Id
             * Format: uuid
             */
            milestone_id: string;
            /** Text */
            text: string;
            /** Amount Minor */
            amount_minor: number;
        };
        /**
         * AdditionUndo
         * @description The cues whose addition is undone: all that the newest revision added.
         */
        AdditionUndo: {
            /** Cue Ids */
            cue_ids: string[];
        };
        /**
         * AddressProof
         * @description How the address of an account was verified.
         * @enum {string}
         */
        AddressProof: "mail" | "operator";
        /**
         * AdviceRead
         * @description One thing that is unwise about a plan.
         */
        AdviceRead: {
            /** Code */
            code: string;
            /** Message */
            message: string;
            /** Why */
            why: string;
        };
        /**
         * AnswerAdd
         * @description The answer, which joins the cue's description unless the request says otherwise.
         */
        AnswerAdd: {
            /** Text */
            text: string;
            /**
             * Joins
             * @default true
             */
            joins: boolean;
        };
        /**
         * AnswerKind
         * @description What the studio says to a redline.
         * @enum {string}
         */
        "AnswerKind-Input": "accepted" | "refused" | "countered";
        /**
         * ApproverAdd
         * @description The new approver, and why.
         */
        ApproverAdd: {
            /**
             * Person Id
             * Format: uuid
             */
            person_id: string;
            /** Reason */
            reason: string;
        };
        /**
         * ApproverChangeRead
         * @description The new approver, the former one, and why.
         */
        ApproverChangeRead: {
            person: components["schemas"]["PersonBrief"];
            /** Reason */
            reason: string;
            changer: components["schemas"]["PersonBrief"];
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
        };
        /**
         * ApproverInvite
         * @description The address of the person who becomes the approver.
         */
        ApproverInvite: {
            /** Email */
            email: string;
        };
        /**
         * ApproverInvited
         * @description Whether the address is the approver now, or becomes it on joining.
         */
        ApproverInvited: {
            /** Email */
            email: string;
            /**
             * Is Named
             * @description A member of the studio is named at once; others once they join.
             */
            is_named: boolean;
        };
        /**
         * ArchiveAdd
         * @description A finished upload that is a ZIP of takes.
         */
        ArchiveAdd: {
            /**
             * Upload Id
             * Format: uuid
             */
            upload_id: string;
            /**
             * File Name
             * @description Never used as a path.
             */
            file_name: string;
        };
        /**
         * ArchiveEntry
         * @description The result for one file in a ZIP.
         */
        ArchiveEntry: {
            /** Path */
            path: string;
            /** Taken */
            taken: boolean;
            /** Take Id */
            take_id: string | null;
            /**
             * Reason
             * @description Why it was left out, or that it was here before.
             */
            reason: string | null;
        };
        /**
         * ArchiveRead
         * @description A delivered ZIP and what became of it.
         */
        ArchiveRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /**
             * Delivery Id
             * Format: uuid
             */
            delivery_id: string;
            /** File Name */
            file_name: string;
            /** Archive Bytes */
            archive_bytes: number;
            state: components["schemas"]["ArchiveState"];
            /** Message */
            message: string;
            /** Entries */
            entries: components["schemas"]["ArchiveEntry"][];
            /**
             * Received At
             * Format: date-time
             */
            received_at: string;
        };
        /**
         * ArchiveState
         * @description The state of a delivered ZIP.
         * @enum {string}
         */
        ArchiveState: "received" | "unpacked" | "refused";
        /**
         * AskedLine
         * @description One line that every bid is made on, counted from the sound list.
         */
        AskedLine: {
            /**
             * Key
             * @description The category; empty for cues without one.
             */
            key: string;
            /** Label */
            label: string;
            /** Cues */
            cues: number;
            /** Files */
            files: number;
        };
        /**
         * AskedQuestion
         * @description A question that waits for an answer.
         */
        AskedQuestion: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            cue: components["schemas"]["CueBrief"];
            /** Text */
            text: string;
            asked_by: components["schemas"]["PersonBrief"];
            /**
             * Asked At
             * Format: date-time
             */
            asked_at: string;
            /** Answer */
            answer: string | null;
            /** Answered At */
            answered_at: string | null;
        };
        /**
         * AskedScope
         * @description Which cues a posting asks for.
         * @enum {string}
         */
        AskedScope: "all" | "categories" | "cues";
        /**
         * Awaited
         * @description Something that another person is to do, for which the caller waits.
         */
        Awaited: {
            kind: components["schemas"]["AwaitedKind"];
            /** Who */
            who: string;
            /** Person Id */
            person_id?: string | null;
            /**
             * Count
             * @default 1
             */
            count: number;
            /**
             * Subject
             * @default
             */
            subject: string;
            /** Since */
            since: string | null;
            /** Contract Id */
            contract_id?: string | null;
        };
        /**
         * AwaitedKind
         * @description What another person is to do.
         * @enum {string}
         */
        AwaitedKind: "join" | "bids" | "nda" | "signature" | "verdicts" | "answer" | "fixes" | "invoice" | "payment";
        /**
         * BandsRead
         * @description The spectrum of a sound, in sixths of an octave.
         */
        BandsRead: {
            /**
             * Hz
             * @description The centre of each band.
             */
            hz: number[];
            /**
             * Dbfs
             * @description RMS within it, over the whole sound; null for silence.
             */
            dbfs: (number | null)[];
        };
        /**
         * Baseline
         * @description The baseline for `audio-checks check --baseline`.
         */
        Baseline: {
            /**
             * Format
             * @default 1
             * @constant
             */
            format: 1;
            /** Waived */
            waived: components["schemas"]["WaivedSound"][];
        };
        /**
         * BatchAdd
         * @description What to render again.
         */
        BatchAdd: {
            /**
             * Targets
             * @description Empty: all of the spec's.
             */
            targets?: string[];
        };
        /**
         * BatchRead
         * @description One batch with what it did to the sizes, and the first game files that it could not make.
         */
        BatchRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Number */
            number: number;
            state: components["schemas"]["BatchState"];
            /**
             * Targets
             * @description Empty: all that the spec has.
             */
            targets: string[];
            /**
             * By Spec
             * @description A change of the spec asked for it, and no person.
             */
            by_spec: boolean;
            /**
             * Note
             * @description Why it ended early.
             */
            note: string;
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            /** Ended At */
            ended_at: string | null;
            /** Files */
            files: number;
            /** Waiting */
            waiting: number;
            /** Made */
            made: number;
            /**
             * Kept
             * @description Game files that are what is wanted already.
             */
            kept: number;
            /** Refused */
            refused: number;
            /**
             * Left
             * @description Game files whose version may not ship at the moment, or whose master is lost.
             */
            left: number;
            /** Sizes */
            sizes: components["schemas"]["BatchSizes"][];
            /** Trouble */
            trouble: components["schemas"]["BatchTrouble"][];
        };
        /**
         * BatchSizes
         * @description The bytes of a target's game files of one category, before and after.
         */
        BatchSizes: {
            /** Target */
            target: string;
            /** Category */
            category: string;
            /** Files */
            files: number;
            /** Before Bytes */
            before_bytes: number;
            /** After Bytes */
            after_bytes: number;
        };
        /**
         * BatchState
         * @description The state of a batch.
         * @enum {string}
         */
        BatchState: "planning" | "running" | "done" | "cancelled";
        /**
         * BatchSummary
         * @description One batch and how far it is.
         */
        BatchSummary: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Number */
            number: number;
            state: components["schemas"]["BatchState"];
            /**
             * Targets
             * @description Empty: all that the spec has.
             */
            targets: string[];
            /**
             * By Spec
             * @description A change of the spec asked for it, and no person.
             */
            by_spec: boolean;
            /**
             * Note
             * @description Why it ended early.
             */
            note: string;
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            /** Ended At */
            ended_at: string | null;
            /** Files */
            files: number;
            /** Waiting */
            waiting: number;
            /** Made */
            made: number;
            /**
             * Kept
             * @description Game files that are what is wanted already.
             */
            kept: number;
            /** Refused */
            refused: number;
            /**
             * Left
             * @description Game files whose version may not ship at the moment, or whose master is lost.
             */
            left: number;
        };
        /**
         * BatchTrouble
         * @description A game file that a batch could not make, and why.
         */
        BatchTrouble: {
            /** Cue */
            cue: string;
            /** Name */
            name: string;
            /** Target */
            target: string;
            /** Reason */
            reason: string;
        };
        /**
         * BidComparison
         * @description The bids of a posting on the same lines; those shortlisted first, then the first sent first.
         */
        BidComparison: {
            /**
             * Posting Id
             * Format: uuid
             */
            posting_id: string;
            /** Title */
            title: string;
            state: components["schemas"]["PostingState"];
            /** Currency */
            currency: string;
            /** Budget Minor */
            budget_minor: number | null;
            /** Rate Floor Minor */
            rate_floor_minor: number | null;
            /** Work From On */
            work_from_on: string | null;
            /** Work To On */
            work_to_on: string | null;
            /** Headings */
            headings: string[];
            /** Lines */
            lines: components["schemas"]["AskedLine"][];
            /** Bids */
            bids: components["schemas"]["ComparedBid"][];
            /** Awarded Bid Id */
            awarded_bid_id: string | null;
            /** Contract Id */
            contract_id: string | null;
            /** May Award */
            may_award: boolean;
            /**
             * Pending
             * @description Who was invited and has not sent a bid: names, or addresses.
             */
            pending: string[];
        };
        /**
         * BidContent
         * @description What a designer offers.
         */
        BidContent: {
            /** Lines */
            lines: components["schemas"]["BidLine"][];
            /**
             * Hours Hundredths
             * @description The whole work in hours: 16000 for 160.
             */
            hours_hundredths?: number | null;
            /** From On */
            from_on?: string | null;
            /** To On */
            to_on?: string | null;
            /**
             * Note
             * @default
             */
            note: string;
        };
        /**
         * BidLine
         * @description One line of a bid.
         */
        BidLine: {
            /**
             * Key
             * @description The asked line's key; for an extra, what it is for.
             */
            key: string;
            kind: components["schemas"]["BidLineKind"];
            unit: components["schemas"]["BidUnit"];
            /**
             * Quantity Hundredths
             * @description 300 for three cues, 750 for seven and a half hours.
             */
            quantity_hundredths: number;
            /**
             * Price Minor
             * @description For one cue, one hour, or the whole.
             */
            price_minor: number;
            /**
             * Note
             * @default
             */
            note: string;
        };
        /**
         * BidLineKind
         * @description What a line of a bid is for: one asked for by the posting, or an extra.
         * @enum {string}
         */
        BidLineKind: "asked" | "rush" | "voice" | "direction" | "narration" | "music";
        /**
         * BidSend
         * @description A bid to send.
         */
        BidSend: {
            /**
             * Revision
             * @description The revision that was read: what is sent is what was seen.
             */
            revision: number;
        };
        /**
         * BidState
         * @description Where a bid is; what happened to a sent one follows from its posting.
         * @enum {string}
         */
        BidState: "draft" | "sent" | "withdrawn";
        /**
         * BidUnit
         * @description What the price of a line counts.
         * @enum {string}
         */
        BidUnit: "per_cue" | "per_hour" | "flat";
        /**
         * BidWrite
         * @description A designer's own bid, to keep as a draft.
         */
        BidWrite: {
            /** Lines */
            lines: components["schemas"]["BidLine"][];
            /**
             * Hours Hundredths
             * @description The whole work in hours: 16000 for 160.
             */
            hours_hundredths?: number | null;
            /** From On */
            from_on?: string | null;
            /** To On */
            to_on?: string | null;
            /**
             * Note
             * @default
             */
            note: string;
            /**
             * Revision
             * @description The revision that was read; 0 for a bid that begins.
             */
            revision: number;
        };
        /**
         * BlockRead
         * @description A head, a paragraph, one item of a list, or a table whose first row is its head.
         */
        BlockRead: {
            /**
             * Kind
             * @enum {string}
             */
            kind: "head" | "text" | "item" | "table";
            /** Level */
            level: number;
            /** Spans */
            spans: components["schemas"]["SpanRead"][];
            /** Rows */
            rows: components["schemas"]["SpanRead"][][][];
        };
        /**
         * BonusRead
         * @description The bonus of a contract, and what became of it.
         */
        BonusRead: {
            /** Amount Minor */
            amount_minor: number;
            when: components["schemas"]["BonusWhen"];
            /** @description Null for a trigger in the parties' own words, which they see to. */
            state: components["schemas"]["BonusState"] | null;
            /**
             * Because
             * @description Why it is so; of a trigger in the parties' own words, these.
             */
            because: string;
        };
        /**
         * BonusState
         * @description What became of a bonus.
         * @enum {string}
         */
        BonusState: "earned" | "possible" | "missed";
        /**
         * BonusWhen
         * @description What sets a bonus off.
         * @enum {string}
         */
        BonusWhen: "other" | "on_time" | "no_rejected_take" | "shipped";
        /**
         * BoundRead
         * @description What a sealed file binds, and whom.
         */
        BoundRead: {
            /** Title */
            title: string;
            kind: components["schemas"]["ContractKind"];
            /** Version */
            version: number;
            /** Text Sha256 */
            text_sha256: string;
            /** Studio Name */
            studio_name: string;
            /** Designer Name */
            designer_name: string;
            /** Agreed At */
            agreed_at: string | null;
            /**
             * Sealed At
             * Format: date-time
             */
            sealed_at: string;
            /** Is Timestamped */
            is_timestamped: boolean;
            /** Signatures */
            signatures: components["schemas"]["BoundSignatureRead"][];
        };
        /**
         * BoundSignatureRead
         * @description A signature under a sealed text.
         */
        BoundSignatureRead: {
            party: components["schemas"]["Party"];
            /** Name */
            name: string;
            /**
             * Signed At
             * Format: date-time
             */
            signed_at: string;
        };
        /**
         * BriefAnswerRead
         * @description The answer to a question.
         */
        BriefAnswerRead: {
            /**
             * Value
             * @description What it is depends on the question's kind; null where it is not known yet.
             */
            value: unknown;
            /**
             * Is Unknown
             * @description The answer is "I don't know yet": the question stays open.
             */
            is_unknown: boolean;
            /** Note */
            note: string;
            /**
             * Words
             * @description The answer as a text.
             */
            words: string;
            /**
             * Revision
             * @description The revision of the brief that changed it last.
             */
            revision: number;
            answered_by: components["schemas"]["PersonBrief"];
            /**
             * Answered At
             * Format: date-time
             */
            answered_at: string;
        };
        /**
         * BriefAnswerWrite
         * @description One answer. Without a value, and not unknown: the answer is removed.
         */
        BriefAnswerWrite: {
            /** Value */
            value?: unknown;
            /**
             * Is Unknown
             * @default false
             */
            is_unknown: boolean;
            /**
             * Note
             * @default
             */
            note: string;
        };
        /**
         * BriefChange
         * @description Answers that change; those left out stay.
         */
        BriefChange: {
            /**
             * Revision
             * @description The revision that was read.
             */
            revision: number;
            /** Answers */
            answers: {
                [key: string]: components["schemas"]["BriefAnswerWrite"];
            };
        };
        /**
         * BriefChoice
         * @description One answer that can be picked.
         */
        BriefChoice: {
            /** Key */
            key: string;
            /** Label */
            label: string;
        };
        /**
         * BriefComparison
         * @description The answers that differ between two versions; `to_version` null is the brief as it stands.
         */
        BriefComparison: {
            /** From Version */
            from_version: number;
            /** To Version */
            to_version: number | null;
            /** Differences */
            differences: components["schemas"]["BriefDifference"][];
        };
        /**
         * BriefDifference
         * @description A question whose answer differs.
         */
        BriefDifference: {
            /** Question */
            question: string;
            /** Number */
            number: number;
            /** Text */
            text: string;
            /** Before */
            before: string;
            /** After */
            after: string;
        };
        /**
         * BriefDocument
         * @description The brief of a project as it stands.
         */
        BriefDocument: {
            /** Topics */
            topics: components["schemas"]["BriefTopicRead"][];
            /** Answered */
            answered: number;
            /** Total */
            total: number;
            /**
             * Open
             * @description Keys of the questions without an answer, in their order.
             */
            open: string[];
            /** Open Required */
            open_required: string[];
            /**
             * Revision
             * @description 0 while nothing is answered. Send it back with a change.
             */
            revision: number;
            /** Changed At */
            changed_at: string | null;
            /**
             * Newest Version
             * @description 0 while none is published.
             */
            newest_version: number;
            /**
             * Differs
             * @description Whether the answers differ from those of the newest version.
             */
            differs: boolean;
            /** May Answer */
            may_answer: boolean;
            /** May Ask */
            may_ask: boolean;
            /** Follow Ups */
            follow_ups: components["schemas"]["FollowUpRead"][];
        };
        /**
         * BriefQuestionRead
         * @description One question of the brief with its answer.
         */
        BriefQuestionRead: {
            /** Key */
            key: string;
            /** Number */
            number: number;
            /** Text */
            text: string;
            /** Why */
            why: string;
            /** Example */
            example: string;
            kind: components["schemas"]["app__briefs__questions__AnswerKind"];
            /** Choices */
            choices: components["schemas"]["BriefChoice"][];
            /** Unit */
            unit: string;
            /**
             * Required
             * @description Needed before a contract is signed.
             */
            required: boolean;
            /**
             * Writes
             * @description The table of the delivery spec that the answer writes; empty for none.
             */
            writes: string;
            /**
             * Applies
             * @description Whether it is asked, given the other answers.
             */
            applies: boolean;
            answer: components["schemas"]["BriefAnswerRead"] | null;
        };
        /**
         * BriefTopicRead
         * @description Questions that are answered together.
         */
        BriefTopicRead: {
            /** Key */
            key: string;
            /** Title */
            title: string;
            /** Lead */
            lead: string;
            /** Answered */
            answered: number;
            /** Total */
            total: number;
            /** Questions */
            questions: components["schemas"]["BriefQuestionRead"][];
        };
        /**
         * BriefVersionAdd
         * @description A version of the brief to publish.
         */
        BriefVersionAdd: {
            /**
             * Note
             * @default
             */
            note: string;
            /**
             * Revision
             * @description The revision that is published.
             */
            revision: number;
        };
        /**
         * BriefVersionRead
         * @description A published version.
         */
        BriefVersionRead: {
            /** Topics */
            topics: components["schemas"]["BriefTopicRead"][];
            /** Answered */
            answered: number;
            /** Total */
            total: number;
            /**
             * Open
             * @description Keys of the questions without an answer, in their order.
             */
            open: string[];
            /** Open Required */
            open_required: string[];
            /** Number */
            number: number;
            /** Note */
            note: string;
            publisher: components["schemas"]["PersonBrief"];
            /**
             * Published At
             * Format: date-time
             */
            published_at: string;
        };
        /**
         * BriefVersionSummary
         * @description A published version, without its answers.
         */
        BriefVersionSummary: {
            /** Number */
            number: number;
            /** Note */
            note: string;
            publisher: components["schemas"]["PersonBrief"];
            /**
             * Published At
             * Format: date-time
             */
            published_at: string;
            /** Answered */
            answered: number;
            /** Total */
            total: number;
        };
        /**
         * BuildAdd
         * @description The report of a game's CI on one build.
         */
        BuildAdd: {
            /** Label */
            label: string;
            /**
             * Commit
             * @default
             */
            commit: string;
            /**
             * Target
             * @default
             */
            target: string;
            report: components["schemas"]["CheckReport"];
        };
        /**
         * BuildBrief
         * @description One run of the game's CI.
         */
        BuildBrief: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Label */
            label: string;
            /** Commit */
            commit: string;
            /** Target */
            target: string;
            /** Files */
            files: number;
            /** Rejected */
            rejected: number;
            /** Warnings */
            warnings: number;
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
        };
        /**
         * BuildRead
         * @description One build with its whole report.
         */
        BuildRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Label */
            label: string;
            /** Commit */
            commit: string;
            /** Target */
            target: string;
            /** Files */
            files: number;
            /**
             * Rejected
             * @description Files that are refused: rejected without a waiver, unreadable or unjudged.
             */
            rejected: number;
            /** Warnings */
            warnings: number;
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            /** Report */
            report: {
                [key: string]: unknown;
            };
        };
        /**
         * BuildSummary
         * @description One build, without its report.
         */
        BuildSummary: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Label */
            label: string;
            /** Commit */
            commit: string;
            /** Target */
            target: string;
            /** Files */
            files: number;
            /**
             * Rejected
             * @description Files that are refused: rejected without a waiver, unreadable or unjudged.
             */
            rejected: number;
            /** Warnings */
            warnings: number;
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
        };
        /**
         * CalendarLinkMade
         * @description The address of a calendar; its secret is shown this once.
         */
        CalendarLinkMade: {
            /** Url */
            url: string;
        };
        /**
         * CalendarRead
         * @description The calendar of a studio, by which working days are counted.
         */
        CalendarRead: {
            /** Time Zone */
            time_zone: string;
            /** Holidays */
            holidays: components["schemas"]["HolidayRead"][];
        };
        /**
         * CalendarSave
         * @description The calendar of a studio.
         */
        CalendarSave: {
            /**
             * Time Zone
             * @description Of the IANA list.
             * @example Europe/Berlin
             */
            time_zone: string;
            /**
             * Holidays
             * @description Besides Saturdays and Sundays.
             * @default []
             */
            holidays: components["schemas"]["HolidayAdd"][];
        };
        /**
         * CameBack
         * @description A take that is with the designer again.
         */
        CameBack: {
            /**
             * Take Id
             * Format: uuid
             */
            take_id: string;
            cue: components["schemas"]["CueBrief"] | null;
            /** Number */
            number: number | null;
            /** Variation */
            variation: number;
            /** File Name */
            file_name: string;
            /**
             * Status
             * @enum {string}
             */
            status: "returned" | "change_requested" | "unjudged";
            /**
             * Since
             * Format: date-time
             */
            since: string;
            /** Duration S */
            duration_s: number | null;
            /** Thumb */
            thumb: {
                [key: string]: unknown;
            } | null;
            /** Preview Url */
            preview_url: string | null;
            /** Peaks Url */
            peaks_url: string | null;
            /** Findings */
            findings: {
                [key: string]: unknown;
            }[];
            /** Changes */
            changes: {
                [key: string]: unknown;
            }[];
            /**
             * Comments
             * @description What the team said of it, and replies to that and to changes.
             */
            comments: components["schemas"]["CommentRead"][];
            /** Round */
            round: number | null;
            /** Limit Dbfs */
            limit_dbfs: number | null;
        };
        /**
         * CandidateAdd
         * @description An address to invite.
         */
        CandidateAdd: {
            /** Email */
            email: string;
        };
        /**
         * CandidateRead
         * @description A person who may bid.
         */
        CandidateRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Email */
            email: string;
            /** @description Null until the link was opened with an account. */
            person: components["schemas"]["PersonBrief"] | null;
            /**
             * Is Invited
             * @description False where the person came by the posting's link.
             */
            is_invited: boolean;
            /** Joined At */
            joined_at: string | null;
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
        };
        /**
         * CarriedNote
         * @description A note on a version for which a change was requested; it is carried over to later ones until it is done.
         */
        CarriedNote: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /**
             * Kind
             * @enum {string}
             */
            kind: "comment" | "change";
            /**
             * Take Id
             * Format: uuid
             */
            take_id: string;
            /** Variation */
            variation: number;
            /**
             * Number
             * @description Of the version that it was written on.
             */
            number: number;
            /** Text */
            text: string;
            /** Start S */
            start_s: number | null;
            /** End S */
            end_s: number | null;
            author: components["schemas"]["PersonBrief"];
            /** Decides */
            decides: boolean;
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            answer: components["schemas"]["NoteAnswerRead"] | null;
        };
        /**
         * CategoryApproverName
         * @description The approver of one category.
         */
        CategoryApproverName: {
            /** Category */
            category: string;
            /**
             * Person Id
             * @description Null gives the category back to the project's approver.
             */
            person_id: string | null;
        };
        /**
         * CategoryApproverRead
         * @description A category of the sound list with an approver of its own.
         */
        CategoryApproverRead: {
            /** Category */
            category: string;
            approver: components["schemas"]["PersonBrief"];
        };
        /**
         * CategoryCount
         * @description One category of the sound list.
         */
        CategoryCount: {
            /**
             * Category
             * @description Empty for cues without a category.
             */
            category: string;
            /**
             * Cues
             * @description Cut ones are not counted.
             */
            cues: number;
        };
        /**
         * CategoryCountdown
         * @description The number of files of one category that are still placeholders.
         */
        CategoryCountdown: {
            /** Category */
            category: string;
            /** Files */
            files: number;
            /** Left */
            left: number;
        };
        /**
         * ChangeOfferRead
         * @description Something that changed since both signed, and that no change order says yet.
         */
        ChangeOfferRead: {
            /**
             * Offer
             * @description Names it for good, in a proposal or when it is dismissed.
             */
            offer: string;
            kind: components["schemas"]["OfferKind"];
            /** Text */
            text: string;
            /**
             * Who
             * @description Whose act it was; empty where that is not known.
             */
            who: string;
            /**
             * At
             * Format: date-time
             */
            at: string;
            change: components["schemas"]["OfferedChange"];
            /** @description The other party dismissed it. */
            dismissed: components["schemas"]["OfferDismissed"] | null;
        };
        /**
         * ChangeOrderAdd
         * @description What a party proposes, and why.
         */
        ChangeOrderAdd: {
            /** Reason */
            reason: string;
            /**
             * Begins At Once
             * @description Work begins before both have agreed, at the risk of the party that proposes.
             * @default false
             */
            begins_at_once: boolean;
            /** Changes */
            changes: (components["schemas"]["AddCue"] | components["schemas"]["CutCue"] | components["schemas"]["RepriceCue"] | components["schemas"]["AddRound"] | components["schemas"]["MoveDate"] | components["schemas"]["AddWork"])[];
            /**
             * Offers
             * @description The offers that it takes up; one that is settled already is left out.
             * @default []
             */
            offers: string[];
        };
        /**
         * ChangeOrderMay
         * @description What the caller may do with a change order now.
         */
        ChangeOrderMay: {
            /** Agree */
            agree: boolean;
            /** Refuse */
            refuse: boolean;
            /** Withdraw */
            withdraw: boolean;
        };
        /**
         * ChangeOrderRead
         * @description A change order.
         */
        ChangeOrderRead: {
            /** Number */
            number: number;
            state: components["schemas"]["ChangeOrderState"];
            party: components["schemas"]["Party"];
            /** Proposed By */
            proposed_by: string;
            /**
             * Proposed At
             * Format: date-time
             */
            proposed_at: string;
            /** Reason */
            reason: string;
            /** Begins At Once */
            begins_at_once: boolean;
            /** Closed At */
            closed_at: string | null;
            /** Close Reason */
            close_reason: string;
            /** Text Sha256 */
            text_sha256: string;
            /** Blocks */
            blocks: components["schemas"]["BlockRead"][];
            /** @description Null once it is closed: the text says what it was. */
            difference: components["schemas"]["DifferenceRead"] | null;
            /**
             * Problems
             * @description Why it could not be agreed to as it stands.
             */
            problems: string[];
            /** Signed */
            signed: components["schemas"]["SignedRead"][];
            may: components["schemas"]["ChangeOrderMay"];
        };
        /**
         * ChangeOrderState
         * @description How far the parties are with a change order.
         * @enum {string}
         */
        ChangeOrderState: "proposed" | "agreed" | "refused" | "withdrawn" | "lapsed";
        /**
         * ChangeOrdersRead
         * @description The change orders of a contract, and what one may name.
         */
        ChangeOrdersRead: {
            /**
             * Project Id
             * Format: uuid
             */
            project_id: string;
            /**
             * Contract Id
             * Format: uuid
             */
            contract_id: string;
            /** Title */
            title: string;
            /** Currency */
            currency: string;
            my_party: components["schemas"]["Party"] | null;
            /** May Propose */
            may_propose: boolean;
            /** Extra Round Bp */
            extra_round_bp: number;
            /** Orders */
            orders: components["schemas"]["ChangeOrderRead"][];
            /**
             * Offers
             * @description What changed since both signed, the newest first; for the two parties only.
             */
            offers: components["schemas"]["ChangeOfferRead"][];
            /**
             * Milestones
             * @description Open milestones, whose dates can move.
             */
            milestones: components["schemas"]["OrderMilestone"][];
            /**
             * Cues
             * @description Cues under the contract that are not settled.
             */
            cues: components["schemas"]["OrderCue"][];
            /**
             * Cues To Add
             * @description Cues of the list that no running contract covers.
             */
            cues_to_add: components["schemas"]["ContractedCue"][];
        };
        /**
         * ChangePreview
         * @description What a change order would do, and what is wrong with it; nothing is saved.
         */
        ChangePreview: {
            difference: components["schemas"]["DifferenceRead"] | null;
            /** Problems */
            problems: string[];
        };
        /**
         * ChangeRequestRead
         * @description A change request for a take; a draft while `sent_at` is null.
         */
        ChangeRequestRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /**
             * Take Id
             * Format: uuid
             */
            take_id: string;
            /**
             * Cue Id
             * Format: uuid
             */
            cue_id: string;
            /** Cue Label */
            cue_label: string;
            /** Cue Name */
            cue_name: string;
            /** Variation */
            variation: number;
            /** Number */
            number: number;
            /** Text */
            text: string;
            /** Start S */
            start_s: number | null;
            /** End S */
            end_s: number | null;
            /**
             * Reverses
             * @description Whether the take is approved now, so that sending counts no round.
             */
            reverses: boolean;
            written_by: components["schemas"]["PersonBrief"];
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            /** Feedback Id */
            feedback_id: string | null;
            /** Sent At */
            sent_at: string | null;
        };
        /**
         * ChangedMilestone
         * @description A milestone before and after.
         */
        ChangedMilestone: {
            /** Name */
            name: string;
            /** Is Deposit */
            is_deposit: boolean;
            /** Amount Before Minor */
            amount_before_minor: number;
            /** Amount After Minor */
            amount_after_minor: number;
            /** Due Before */
            due_before: string | null;
            /** Due After */
            due_after: string | null;
        };
        /**
         * ChangedPath
         * @description A game file that is not as it was in an earlier pack.
         */
        ChangedPath: {
            /** Path */
            path: string;
            /**
             * Kind
             * @enum {string}
             */
            kind: "new" | "changed" | "gone";
        };
        /**
         * ChangesSet
         * @description Changes to look at before one proposes them.
         */
        ChangesSet: {
            /** Changes */
            changes: (components["schemas"]["AddCue"] | components["schemas"]["CutCue"] | components["schemas"]["RepriceCue"] | components["schemas"]["AddRound"] | components["schemas"]["MoveDate"] | components["schemas"]["AddWork"])[];
        };
        /**
         * CheckDescription
         * @description A check: what it is called, why it is there, and what a spec may state of it.
         */
        CheckDescription: {
            /**
             * Name
             * @example true-peak
             */
            name: string;
            /** Label */
            label: string;
            /**
             * Summary
             * @description What holds of a sound when it finds nothing.
             */
            summary: string;
            /** Why */
            why: string;
            /** How To Fix */
            how_to_fix: string;
            /**
             * Severity
             * @description Where the spec says nothing.
             * @enum {string}
             */
            severity: "error" | "warning";
            /**
             * May Return
             * @description Whether a spec may make it an error, so that takes are returned for it.
             */
            may_return: boolean;
            /**
             * Is In Categories
             * @description Whether the form of a category offers its severity.
             */
            is_in_categories: boolean;
            /** Limits */
            limits: components["schemas"]["CheckLimitDescription"][];
        };
        /**
         * CheckLimitDescription
         * @description A limit that a check holds files to.
         */
        CheckLimitDescription: {
            /**
             * Key
             * @description In the table `limits` of a spec.
             * @example true_peak_dbtp
             */
            key: string;
            /** Label */
            label: string;
            /** Unit */
            unit: string;
            /** Least */
            least: number;
            /** Greatest */
            greatest: number;
            /**
             * Is Range
             * @description Whether a spec states `min` and `max`.
             */
            is_range: boolean;
            /**
             * Usual
             * @description What holds where the spec says nothing; null for no limit.
             */
            usual: number | null;
        };
        /**
         * CheckRead
         * @description The newest check of a take.
         */
        CheckRead: {
            /**
             * Take Id
             * Format: uuid
             */
            take_id: string;
            state: components["schemas"]["TakeState"];
            /**
             * Verdict
             * @enum {string}
             */
            verdict: "conforming" | "rejected" | "unreadable" | "unjudged";
            /** Spec Version */
            spec_version: number;
            /**
             * Is Newest Spec
             * @description The newest spec asks nothing else of this take.
             */
            is_newest_spec: boolean;
            /** Tool Version */
            tool_version: string;
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            /** Facts */
            facts: {
                [key: string]: unknown;
            } | null;
            /** Measurements */
            measurements: {
                [key: string]: unknown;
            };
            /** Judgements */
            judgements: {
                [key: string]: unknown;
            };
            dry_stem: components["schemas"]["ComparedStemRead"] | null;
            /**
             * Is Newest Stem
             * @description This check heeds the dry stem that there is now, or that there is none.
             */
            is_newest_stem: boolean;
            /** Findings */
            findings: components["schemas"]["FindingRead"][];
            waiver: components["schemas"]["WaiverRead"] | null;
        };
        /**
         * CheckReport
         * @description A report of audio-checks, as its JSON format has it.
         */
        CheckReport: {
            /**
             * Schema Version
             * @constant
             */
            schema_version: 1;
            tool: components["schemas"]["ReportTool"];
            spec: components["schemas"]["ReportSpec"] | null;
            /** Files */
            files: components["schemas"]["ReportFile"][];
            /** Summary */
            summary: {
                [key: string]: number;
            };
        } & {
            [key: string]: unknown;
        };
        /**
         * ChoiceRead
         * @description One of the values that a term may have, and what the text says then.
         */
        ChoiceRead: {
            /** Value */
            value: number | string;
            /** Label */
            label: string;
            /** Words */
            words: string;
        };
        /**
         * CiLines
         * @description Shell lines for the game's CI; the token goes into its secrets as SOUNDLIST_TOKEN.
         */
        CiLines: {
            /** Lines */
            lines: string[];
        };
        /**
         * ClarityRead
         * @description What the clarity check says of a list.
         */
        ClarityRead: {
            /** Unclear */
            unclear: components["schemas"]["UnclearCue"][];
        };
        /**
         * Clash
         * @description An offer or award elsewhere, in the days of this posting.
         */
        Clash: {
            /** Title */
            title: string;
            /** Is Awarded */
            is_awarded: boolean;
            /**
             * From On
             * Format: date
             */
            from_on: string;
            /**
             * To On
             * Format: date
             */
            to_on: string;
        };
        /**
         * ClauseRow
         * @description One clause: Markdown with variables in braces; what does not stand is kept, and not in the text.
         */
        ClauseRow: {
            /** Key */
            key: string;
            /** Title */
            title: string;
            /** Text */
            text: string;
            /**
             * Stands
             * @default true
             */
            stands: boolean;
        };
        /**
         * CommentAdd
         * @description Advice on a take, at a time in the sound or on the whole of it.
         */
        CommentAdd: {
            /** Text */
            text: string;
            /** Start S */
            start_s?: number | null;
            /** End S */
            end_s?: number | null;
            /**
             * Reply To Id
             * @description The comment on the same take that it answers.
             */
            reply_to_id?: string | null;
            /**
             * Change Request Id
             * @description The sent change request that it answers.
             */
            change_request_id?: string | null;
        };
        /**
         * CommentRead
         * @description Advice on a take.
         */
        CommentRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /**
             * Take Id
             * Format: uuid
             */
            take_id: string;
            /** Reply To Id */
            reply_to_id: string | null;
            /** Change Request Id */
            change_request_id: string | null;
            /** Text */
            text: string;
            /** Start S */
            start_s: number | null;
            /** End S */
            end_s: number | null;
            author: components["schemas"]["PersonBrief"];
            /**
             * Decides
             * @description Whether the author was the approver when writing; all others advise.
             */
            decides: boolean;
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            /** Resolved At */
            resolved_at: string | null;
        };
        /**
         * ComparedBid
         * @description One bid beside the others.
         */
        ComparedBid: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            designer: components["schemas"]["PersonBrief"];
            /** Is Shortlisted */
            is_shortlisted: boolean;
            /**
             * Sent At
             * Format: date-time
             */
            sent_at: string;
            /** Resent At */
            resent_at: string | null;
            content: components["schemas"]["BidContent"];
            /**
             * Amounts Minor
             * @description Of each line, in the order of the lines.
             */
            amounts_minor: number[];
            /** Total Minor */
            total_minor: number;
            /**
             * Missing
             * @description Asked lines without an offer: the total is not comparable.
             */
            missing: string[];
            /**
             * Hourly Rate Minor
             * @description The total divided by the hours; null without hours.
             */
            hourly_rate_minor: number | null;
            /** Is Below Floor */
            is_below_floor: boolean;
            /**
             * Over Budget Minor
             * @description Below zero: under it. Null where no budget is named.
             */
            over_budget_minor: number | null;
            /**
             * Days Late
             * @description How many days after the posting's last day the work ends.
             */
            days_late: number | null;
            own_scores: components["schemas"]["PersonScores"] | null;
            /**
             * Others
             * @description Null until the caller has given every score of their own.
             */
            others: components["schemas"]["PersonScores"][] | null;
            /**
             * Scored By
             * @description How many people have scored it.
             */
            scored_by: number;
        };
        /**
         * ComparedRead
         * @description One line of a comparison.
         */
        ComparedRead: {
            /**
             * Kind
             * @enum {string}
             */
            kind: "head" | "text" | "item" | "table";
            /**
             * Change
             * @enum {string}
             */
            change: "same" | "changed" | "added" | "removed";
            /** Runs */
            runs: components["schemas"]["RunRead"][];
        };
        /**
         * ComparedStemRead
         * @description The dry stem that a take has now; `judgements.reverb.stem` has what was found with it.
         */
        ComparedStemRead: {
            /** File Name */
            file_name: string;
            /** File Bytes */
            file_bytes: number;
            /** Sha256 */
            sha256: string;
            /**
             * Received At
             * Format: date-time
             */
            received_at: string;
        };
        /**
         * ComparisonRead
         * @description Two versions word by word.
         */
        ComparisonRead: {
            /** From Version */
            from_version: number;
            /** To Version */
            to_version: number;
            /** Lines */
            lines: components["schemas"]["ComparedRead"][];
        };
        /**
         * ContractAdd
         * @description A contract to begin with one designer.
         */
        ContractAdd: {
            /**
             * Engagement Id
             * Format: uuid
             */
            engagement_id: string;
            kind: components["schemas"]["ContractKind"];
            /** Title */
            title: string;
            /**
             * Currency
             * @default USD
             */
            currency: string;
            /** Template Id */
            template_id?: string | null;
            /** Framework Id */
            framework_id?: string | null;
            /**
             * Same As Id
             * @description A contract of the studio, whose clauses and terms it begins with.
             */
            same_as_id?: string | null;
            /**
             * With Music
             * @default false
             */
            with_music: boolean;
        };
        /**
         * ContractBrief
         * @description A contract as lists show it.
         */
        ContractBrief: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /**
             * Project Id
             * Format: uuid
             */
            project_id: string;
            /** Number */
            number: number;
            /** Title */
            title: string;
            kind: components["schemas"]["ContractKind"];
            state: components["schemas"]["ContractState"];
            designer: components["schemas"]["PersonBrief"];
            /**
             * Engagement Id
             * Format: uuid
             */
            engagement_id: string;
            /** Framework Id */
            framework_id: string | null;
            /** Currency */
            currency: string;
            release_clause: components["schemas"]["ReleaseClause"];
            /** Deposit Bp */
            deposit_bp: number;
            /** Holdback Bp */
            holdback_bp: number;
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            /** Agreed At */
            agreed_at: string | null;
            /** Ended At */
            ended_at: string | null;
            /** End Reason */
            end_reason: string | null;
            my_party: components["schemas"]["Party"] | null;
            /**
             * Waits For
             * @description Whose step is next.
             */
            waits_for: components["schemas"]["Party"][];
        };
        /**
         * ContractChangeAdd
         * @description What the designer wants otherwise, of one clause or of the whole.
         */
        ContractChangeAdd: {
            /** Text */
            text: string;
            /** Clause Key */
            clause_key?: string | null;
        };
        /**
         * ContractChangeRead
         * @description What the designer wants otherwise.
         */
        ContractChangeRead: {
            /** Text */
            text: string;
            /** Clause */
            clause: string;
            /** By */
            by: string;
            /**
             * At
             * Format: date-time
             */
            at: string;
        };
        /**
         * ContractKind
         * @description What is agreed by one text.
         * @enum {string}
         */
        ContractKind: "nda" | "framework" | "statement_of_work" | "single";
        /**
         * ContractMoney
         * @description The money of one agreed contract; amounts in whole minor units.
         */
        ContractMoney: {
            /**
             * Contract Id
             * Format: uuid
             */
            contract_id: string;
            /** Title */
            title: string;
            designer: components["schemas"]["PersonBrief"];
            /** Currency */
            currency: string;
            release: components["schemas"]["ReleaseClause"];
            /** Kill Fee In Work Bp */
            kill_fee_in_work_bp: number;
            by_day: components["schemas"]["DayRateRead"] | null;
            figures: components["schemas"]["FiguresRead"];
            /** Milestones */
            milestones: components["schemas"]["MilestoneRead"][];
            /** Slips */
            slips: components["schemas"]["MilestoneSlip"][];
            /** Slip Growth Days */
            slip_growth_days: number | null;
            /** Proposed Rounds */
            proposed_rounds: components["schemas"]["ExtraRoundRead"][];
            /** Billable Minor */
            billable_minor: number;
            /** Next Invoice */
            next_invoice: number;
            /** Open Invoices */
            open_invoices: components["schemas"]["InvoiceRead"][];
            /** Last Days To Pay */
            last_days_to_pay: number | null;
        };
        /**
         * ContractRead
         * @description A contract with the text that the caller sees, and who said yes to it.
         */
        ContractRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /**
             * Project Id
             * Format: uuid
             */
            project_id: string;
            /** Number */
            number: number;
            /** Title */
            title: string;
            kind: components["schemas"]["ContractKind"];
            state: components["schemas"]["ContractState"];
            designer: components["schemas"]["PersonBrief"];
            /**
             * Engagement Id
             * Format: uuid
             */
            engagement_id: string;
            /** Framework Id */
            framework_id: string | null;
            /** Currency */
            currency: string;
            release_clause: components["schemas"]["ReleaseClause"];
            /** Deposit Bp */
            deposit_bp: number;
            /** Holdback Bp */
            holdback_bp: number;
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            /** Agreed At */
            agreed_at: string | null;
            /** Ended At */
            ended_at: string | null;
            /** End Reason */
            end_reason: string | null;
            my_party: components["schemas"]["Party"] | null;
            /**
             * Waits For
             * @description Whose step is next.
             */
            waits_for: components["schemas"]["Party"][];
            /** Studio Name */
            studio_name: string;
            version: components["schemas"]["VersionRead"];
            /** Acceptances */
            acceptances: components["schemas"]["AcceptanceRead"][];
            /**
             * Signers
             * @description Who signs for the studio, in this order; empty: any one of its producers.
             */
            signers: components["schemas"]["PersonBrief"][];
            /** @description Which party signs first; null: either. */
            signs_first: components["schemas"]["Party"] | null;
            /** @description The changes that the designer requests, until it is sent again. */
            change_requested: components["schemas"]["ContractChangeRead"] | null;
            /** @description The last round of changes that the designer proposed clause by clause; null: none yet. */
            redlines: components["schemas"]["ContractRedlines"] | null;
            /** @description Null before it is first sent. */
            signature_time: components["schemas"]["SignatureTime"] | null;
            may: components["schemas"]["MayRead"];
        };
        /**
         * ContractRedlines
         * @description The last round of redlines in figures.
         */
        ContractRedlines: {
            /** Rounds */
            rounds: number;
            /** Count */
            count: number;
            /** Unanswered */
            unanswered: number;
            /**
             * Is Open
             * @description Whether the next version is still to be sent.
             */
            is_open: boolean;
            /** By */
            by: string;
            /**
             * At
             * Format: date-time
             */
            at: string;
        };
        /**
         * ContractState
         * @description How far the parties are.
         * @enum {string}
         */
        ContractState: "draft" | "sent" | "agreed" | "ended";
        /**
         * ContractTemplateAdd
         * @description Under which name to keep a contract's clauses.
         */
        ContractTemplateAdd: {
            /** Name */
            name: string;
        };
        /**
         * ContractedCue
         * @description A cue of the list as contracts name it.
         */
        ContractedCue: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Label */
            label: string;
            /** Name */
            name: string;
        };
        /**
         * CostPerSound
         * @description What a sound that was kept has cost so far, and what the rest would come to; in whole minor units.
         */
        CostPerSound: {
            /** Currency */
            currency: string;
            /** Accepted Minor */
            accepted_minor: number;
            /** Per Kept Minor */
            per_kept_minor: number | null;
            /**
             * To Finish Minor
             * @description What is agreed and not yet accepted or saved.
             */
            to_finish_minor: number | null;
        };
        /**
         * CoverageRead
         * @description What the brief names and the list lacks.
         */
        CoverageRead: {
            /** Scenes Without Ambience */
            scenes_without_ambience: string[];
            /**
             * Silent Scenes
             * @description Scenes with neither ambience nor music in the brief.
             */
            silent_scenes: string[];
            /** Categories Without Cue */
            categories_without_cue: string[];
            /** Priority Without Cue */
            priority_without_cue: string[];
        };
        /**
         * CueAdd
         * @description A typed row; only a name or a file name is needed.
         */
        CueAdd: {
            /**
             * Name
             * @default
             */
            name: string;
            /**
             * File Name
             * @default
             */
            file_name: string;
            /**
             * Category
             * @default
             */
            category: string;
            /**
             * Description
             * @default
             */
            description: string;
            /**
             * Use
             * @default
             */
            use: string;
            /**
             * Trigger
             * @default
             */
            trigger: string;
            /** Duration S */
            duration_s?: number | null;
            /**
             * Length Locked
             * @default false
             */
            length_locked: boolean;
            /** Frame Rate Fps */
            frame_rate_fps?: number | null;
            /**
             * Loop
             * @default false
             */
            loop: boolean;
            reverb?: components["schemas"]["Reverb"] | null;
            /**
             * Variations
             * @default 1
             */
            variations: number;
            /**
             * State
             * @default prototype
             * @enum {string}
             */
            state: "concept" | "prototype" | "locked";
            /** Playback Priority */
            playback_priority?: number | null;
            /** Due On */
            due_on?: string | null;
            /**
             * Placeholder
             * @default false
             */
            placeholder: boolean;
            /**
             * Palette
             * @default false
             */
            palette: boolean;
            /** Extra */
            extra?: {
                [key: string]: string;
            };
        };
        /**
         * CueBrief
         * @description The cue that a take is for.
         */
        CueBrief: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /**
             * Label
             * @example SW-014
             */
            label: string;
            /** Name */
            name: string;
        };
        /**
         * CueCut
         * @description Why the game no longer needs a cue.
         */
        CueCut: {
            /** Reason */
            reason: string;
        };
        /**
         * CueCutRead
         * @description A cut cue.
         */
        CueCutRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            state: components["schemas"]["CueState"];
            /** Cut Reason */
            cut_reason: string;
            /**
             * Cut At
             * Format: date-time
             */
            cut_at: string;
        };
        /**
         * CueDetail
         * @description One cue with what was asked about it.
         */
        CueDetail: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Number */
            number: number;
            /**
             * Label
             * @example SW-014
             */
            label: string;
            /** Position */
            position: number;
            /** Name */
            name: string;
            /** File Name */
            file_name: string;
            /**
             * Stems
             * @description The file names, without ending, that its variations own; none once cut.
             */
            stems: string[];
            /** Category */
            category: string;
            /** Description */
            description: string;
            /** Use */
            use: string;
            /** Trigger */
            trigger: string;
            /** Duration S */
            duration_s: number | null;
            /** Length Locked */
            length_locked: boolean;
            /** Frame Rate Fps */
            frame_rate_fps: number | null;
            /** Loop */
            loop: boolean;
            reverb: components["schemas"]["Reverb"] | null;
            /** Variations */
            variations: number;
            state: components["schemas"]["CueState"];
            /** Playback Priority */
            playback_priority: number | null;
            /**
             * Due On
             * @description The day on which the sound is needed.
             */
            due_on: string | null;
            /** Placeholder */
            placeholder: boolean;
            /** Palette */
            palette: boolean;
            /**
             * Extra
             * @description Imported columns without a field.
             */
            extra: {
                [key: string]: string;
            };
            /**
             * Edition
             * @description Send it back with a change, so that two editors notice each other.
             */
            edition: number;
            /** Cut Reason */
            cut_reason: string | null;
            /** Cut At */
            cut_at: string | null;
            /** Open Questions */
            open_questions: number;
            /**
             * Project Id
             * Format: uuid
             */
            project_id: string;
            /** Questions */
            questions: components["schemas"]["QuestionRead"][];
        };
        /**
         * CueDifference
         * @description A cue that differs between two revisions.
         */
        CueDifference: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Number */
            number: number;
            /** Label */
            label: string;
            /** Name */
            name: string;
            /** Changes */
            changes: components["schemas"]["FieldChange"][];
            /** Cut Reason */
            cut_reason: string | null;
        };
        /**
         * CueGuess
         * @description A cue that an unmatched file is for, or may be for.
         */
        CueGuess: {
            /**
             * Cue Id
             * Format: uuid
             */
            cue_id: string;
            /** Label */
            label: string;
            /** Name */
            name: string;
            /**
             * Variation
             * @description Null where the name does not say which of the set.
             */
            variation: number | null;
            /**
             * Variations
             * @description How many the cue has.
             */
            variations: number;
            /** Reason */
            reason: string;
            /**
             * Becomes
             * @description What the file would be called; null without a variation.
             */
            becomes: string | null;
        };
        /**
         * CueMoneyRead
         * @description What a contract says of one cue, and what accepting it now would do.
         */
        CueMoneyRead: {
            /**
             * Contract Id
             * Format: uuid
             */
            contract_id: string;
            /** Currency */
            currency: string;
            /** Milestone */
            milestone: string;
            /** Amount Minor */
            amount_minor: number;
            /** Would Owe Minor */
            would_owe_minor: number;
            /** Accepted */
            accepted: number;
            /** Accepted Then */
            accepted_then: number;
            /** Wanted */
            wanted: number;
            /** Rounds Included */
            rounds_included: number;
            /** Extra Round Minor */
            extra_round_minor: number;
            /** Extra Rounds */
            extra_rounds: components["schemas"]["ExtraRoundRead"][];
        };
        /**
         * CueOrder
         * @description Cues in their new order: they share out among themselves the places that they hold now.
         */
        CueOrder: {
            /** Cue Ids */
            cue_ids: string[];
        };
        /**
         * CuePatch
         * @description Changes of a cue; omitted fields stay.
         */
        CuePatch: {
            /**
             * Name
             * @default
             */
            name: string;
            /**
             * File Name
             * @default
             */
            file_name: string;
            /**
             * Category
             * @default
             */
            category: string;
            /**
             * Description
             * @default
             */
            description: string;
            /**
             * Use
             * @default
             */
            use: string;
            /**
             * Trigger
             * @default
             */
            trigger: string;
            /** Duration S */
            duration_s?: number | null;
            /**
             * Length Locked
             * @default false
             */
            length_locked: boolean;
            /** Frame Rate Fps */
            frame_rate_fps?: number | null;
            /**
             * Loop
             * @default false
             */
            loop: boolean;
            reverb?: components["schemas"]["Reverb"] | null;
            /**
             * Variations
             * @default 1
             */
            variations: number;
            /**
             * State
             * @default prototype
             * @enum {string}
             */
            state: "concept" | "prototype" | "locked";
            /** Playback Priority */
            playback_priority?: number | null;
            /** Due On */
            due_on?: string | null;
            /**
             * Placeholder
             * @default false
             */
            placeholder: boolean;
            /**
             * Palette
             * @default false
             */
            palette: boolean;
            /** Extra */
            extra?: {
                [key: string]: string;
            };
            /**
             * Edition
             * @description The edition that was read.
             */
            edition: number;
        };
        /**
         * CueProgress
         * @description The progress of one cue.
         */
        CueProgress: {
            /**
             * Cue Id
             * Format: uuid
             */
            cue_id: string;
            status: components["schemas"]["CueStatus"];
            /** Since */
            since: string | null;
            /** Accepted */
            accepted: number;
            /** Wanted */
            wanted: number;
            /** Alternates */
            alternates: number;
            /** Versions */
            versions: number;
            /** Rounds */
            rounds: number;
            /** Variations */
            variations: components["schemas"]["VariationProgress"][];
            newest_take: components["schemas"]["NewestTake"] | null;
            /** Worst Finding */
            worst_finding: {
                [key: string]: unknown;
            } | null;
            /** Open Question */
            open_question: string | null;
            /** Waived */
            waived: boolean;
            /** Not To Spec */
            not_to_spec: boolean;
        };
        /**
         * CueRead
         * @description One line of the list.
         */
        CueRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Number */
            number: number;
            /**
             * Label
             * @example SW-014
             */
            label: string;
            /** Position */
            position: number;
            /** Name */
            name: string;
            /** File Name */
            file_name: string;
            /**
             * Stems
             * @description The file names, without ending, that its variations own; none once cut.
             */
            stems: string[];
            /** Category */
            category: string;
            /** Description */
            description: string;
            /** Use */
            use: string;
            /** Trigger */
            trigger: string;
            /** Duration S */
            duration_s: number | null;
            /** Length Locked */
            length_locked: boolean;
            /** Frame Rate Fps */
            frame_rate_fps: number | null;
            /** Loop */
            loop: boolean;
            reverb: components["schemas"]["Reverb"] | null;
            /** Variations */
            variations: number;
            state: components["schemas"]["CueState"];
            /** Playback Priority */
            playback_priority: number | null;
            /**
             * Due On
             * @description The day on which the sound is needed.
             */
            due_on: string | null;
            /** Placeholder */
            placeholder: boolean;
            /** Palette */
            palette: boolean;
            /**
             * Extra
             * @description Imported columns without a field.
             */
            extra: {
                [key: string]: string;
            };
            /**
             * Edition
             * @description Send it back with a change, so that two editors notice each other.
             */
            edition: number;
            /** Cut Reason */
            cut_reason: string | null;
            /** Cut At */
            cut_at: string | null;
            /** Open Questions */
            open_questions: number;
        };
        /**
         * CueReviewRead
         * @description Everything of one cue that the review room shows: takes in every state, newest first, and what was said.
         */
        CueReviewRead: {
            cue: components["schemas"]["ReviewCue"];
            kind: components["schemas"]["QueueKind"];
            /** Accepted */
            accepted: boolean;
            /** Approved Variations */
            approved_variations: number[];
            /** Accepted After */
            accepted_after: string | null;
            /** Silence Paused By */
            silence_paused_by: ("question" | "change_order") | null;
            /** @description Of the cue's category, else of the project. */
            approver: components["schemas"]["PersonBrief"];
            /**
             * Deputies
             * @description Those who may approve in the approver's place today.
             */
            deputies: components["schemas"]["PersonBrief"][];
            /** May Approve */
            may_approve: boolean;
            /** @description The approver for whom the caller would decide as a deputy. */
            on_behalf_of: components["schemas"]["PersonBrief"] | null;
            /** Takes */
            takes: components["schemas"]["ReviewTake"][];
            /** Comments */
            comments: components["schemas"]["CommentRead"][];
            /** Verdicts */
            verdicts: components["schemas"]["VerdictRead"][];
            /** Change Requests */
            change_requests: components["schemas"]["ChangeRequestRead"][];
            /** Carried Notes */
            carried_notes: components["schemas"]["CarriedNote"][];
            /** Rounds */
            rounds: components["schemas"]["RoundRead"][];
        };
        /**
         * CueState
         * @description How final a cue is.
         * @enum {string}
         */
        CueState: "concept" | "prototype" | "locked" | "cut";
        /**
         * CueStatus
         * @description The one word that a list shows for a cue.
         * @enum {string}
         */
        CueStatus: "to_make" | "checking" | "to_review" | "returned" | "unjudged" | "question" | "change_requested" | "partly_accepted" | "accepted" | "placeholder" | "cut";
        /**
         * CuesAdd
         * @description Typed or pasted rows, in list order.
         */
        CuesAdd: {
            /** Cues */
            cues: components["schemas"]["CueAdd"][];
        };
        /**
         * CurrencyFigures
         * @description The totals of all contracts of one currency.
         */
        CurrencyFigures: {
            /** Currency */
            currency: string;
            figures: components["schemas"]["FiguresRead"];
        };
        /**
         * CutCue
         * @description A cue that the contract covers no more: it is owed by the state of its work when both have agreed.
         */
        CutCue: {
            /**
             * @description discriminator enum property added by openapi-typescript
             * @enum {string}
             */
            kind: "cut_cue";
            /**
             * Cue Id
             * Format: uuid
             */
            cue_id: string;
        };
        /**
         * DayRateRead
         * @description What a contract by the day pays for one, and up to how many of them.
         */
        DayRateRead: {
            /** Day Rate Minor */
            day_rate_minor: number;
            /** Days Cap */
            days_cap: number;
            /** Agreed Minor */
            agreed_minor: number;
            /** Cap Minor */
            cap_minor: number;
        };
        /**
         * DeliveryAdd
         * @description A new delivery.
         */
        DeliveryAdd: {
            /**
             * Note
             * @default
             */
            note: string;
        };
        /**
         * DeliveryChange
         * @description Changes of a delivery.
         */
        DeliveryChange: {
            /** Note */
            note: string;
        };
        /**
         * DeliveryDetail
         * @description A delivery with everything that came in it.
         */
        DeliveryDetail: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /**
             * Project Id
             * Format: uuid
             */
            project_id: string;
            /** Number */
            number: number;
            /** Note */
            note: string;
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            /** Closed At */
            closed_at: string | null;
            designer: components["schemas"]["PersonBrief"];
            /** Takes Count */
            takes_count: number;
            /** Takes */
            takes: components["schemas"]["TakeRead"][];
            /** Dry Stems */
            dry_stems: components["schemas"]["DryStemRead"][];
            /** Archives */
            archives: components["schemas"]["ArchiveRead"][];
        };
        /**
         * DeliveryFitRead
         * @description A delivery compared with other designers' approved sounds.
         */
        DeliveryFitRead: {
            /**
             * Delivery Id
             * Format: uuid
             */
            delivery_id: string;
            /**
             * Project Id
             * Format: uuid
             */
            project_id: string;
            /** Number */
            number: number;
            designer: components["schemas"]["PersonBrief"];
            /**
             * Is First
             * @description The designer delivered nothing to this project before.
             */
            is_first: boolean;
            /** Made Before By */
            made_before_by: string[];
            /** Takes */
            takes: components["schemas"]["TakeFitRead"][];
            /** Shifts */
            shifts: components["schemas"]["DeliveryShift"][];
        };
        /**
         * DeliveryRead
         * @description One upload of takes by a designer, with notes.
         */
        DeliveryRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /**
             * Project Id
             * Format: uuid
             */
            project_id: string;
            /** Number */
            number: number;
            /** Note */
            note: string;
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            /** Closed At */
            closed_at: string | null;
            designer: components["schemas"]["PersonBrief"];
            /** Takes Count */
            takes_count: number;
        };
        /**
         * DeliveryShift
         * @description The distance of a delivery from earlier work by one measure.
         */
        DeliveryShift: {
            measure: components["schemas"]["Measure"];
            /** Unit */
            unit: string;
            /** Compared */
            compared: number;
            /**
             * Apart
             * @description How many of these are out of range.
             */
            apart: number;
            /**
             * Shift
             * @description The median distance above the others' median.
             */
            shift: number;
        };
        /**
         * DeliverySources
         * @description The sources of a delivery.
         */
        DeliverySources: {
            /**
             * Delivery Id
             * Format: uuid
             */
            delivery_id: string;
            /** @description Holds for every take without a statement of its own. */
            stated: components["schemas"]["SourcesRead"] | null;
            /** @description What its designer stated last in this studio. */
            remembered: components["schemas"]["Sources"] | null;
            /** Takes */
            takes: components["schemas"]["TakeSources"][];
        };
        /**
         * DemoPart
         * @description The role that the demo's visitor plays, and the others on offer.
         */
        DemoPart: {
            /** Part */
            part: string;
            /** Parts */
            parts: string[];
        };
        /**
         * DepositAtEnd
         * @description What becomes of the deposit where a contract ends early.
         * @enum {string}
         */
        DepositAtEnd: "stays" | "set_off";
        /**
         * DeputiesRead
         * @description The deputies of today and of later days, and the studio's time zone that their days are counted in.
         */
        DeputiesRead: {
            /** Time Zone */
            time_zone: string;
            /**
             * Today
             * Format: date
             */
            today: string;
            /** Deputies */
            deputies: components["schemas"]["DeputyRead"][];
        };
        /**
         * DeputyAdd
         * @description Who may approve in place of a person, and when.
         */
        DeputyAdd: {
            /**
             * Person Id
             * Format: uuid
             */
            person_id: string;
            /**
             * Deputy Id
             * Format: uuid
             */
            deputy_id: string;
            /**
             * From On
             * Format: date
             * @description The first day, in the studio's time zone.
             */
            from_on: string;
            /**
             * Until On
             * Format: date
             * @description The last day, which counts.
             */
            until_on: string;
        };
        /**
         * DeputyRead
         * @description A deputy of today or of later days.
         */
        DeputyRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            person: components["schemas"]["PersonBrief"];
            deputy: components["schemas"]["PersonBrief"];
            /**
             * From On
             * Format: date
             */
            from_on: string;
            /**
             * Until On
             * Format: date
             */
            until_on: string;
        };
        /**
         * Desk
         * @description A designer's work in one project; of its lists the first page each, and the cursor of the following one.
         */
        Desk: {
            /** Came Back */
            came_back: components["schemas"]["CameBack"][];
            /** Came Back Next */
            came_back_next: string | null;
            /** Came Back Cues */
            came_back_cues: number;
            /** To Make */
            to_make: components["schemas"]["ToMake"][];
            /** To Make Next */
            to_make_next: string | null;
            /** To Make Cues */
            to_make_cues: number;
            /** With Approver */
            with_approver: components["schemas"]["WithApprover"][];
            /** With Approver Next */
            with_approver_next: string | null;
            /** With Approver Cues */
            with_approver_cues: number;
            /** With Approver Files */
            with_approver_files: number;
            /** Accepted */
            accepted: number;
            /** Cues */
            cues: number;
            /** Unmatched */
            unmatched: number;
            /** Checking */
            checking: number;
            /** Questions */
            questions: components["schemas"]["AskedQuestion"][];
        };
        /**
         * DifferenceRead
         * @description What a change order does to scope, price and dates, and to the check of the plan.
         */
        DifferenceRead: {
            /**
             * Changes
             * @description Each change as a sentence.
             */
            changes: string[];
            /** Cues Before */
            cues_before: number;
            /** Cues After */
            cues_after: number;
            /** Price Before Minor */
            price_before_minor: number;
            /** Price After Minor */
            price_after_minor: number;
            /** Milestones */
            milestones: components["schemas"]["ChangedMilestone"][];
            /**
             * Warnings
             * @description What the change order itself makes harder.
             */
            warnings: components["schemas"]["AdviceRead"][];
            /**
             * Advice
             * @description What is unwise about the plan as it will be.
             */
            advice: components["schemas"]["AdviceRead"][];
            /**
             * Advice Gone
             * @description What was unwise and will not be.
             */
            advice_gone: components["schemas"]["AdviceRead"][];
        };
        /**
         * DraftChange
         * @description The whole draft as it is to be.
         */
        DraftChange: {
            /** Title */
            title: string;
            /** Clauses */
            clauses: components["schemas"]["ClauseRow"][];
            /** Terms */
            terms: {
                [key: string]: number | string;
            };
            /** Currency */
            currency: string;
            /** @default per_cue */
            release_clause: components["schemas"]["ReleaseClause"];
            /**
             * Holdback Bp
             * @default 0
             */
            holdback_bp: number;
        };
        /**
         * DraftPreview
         * @description The text that a draft would have, and what is wrong with it.
         */
        DraftPreview: {
            /** Blocks */
            blocks: components["schemas"]["BlockRead"][];
            /** Problems */
            problems: components["schemas"]["DraftProblem"][];
        };
        /**
         * DraftProblem
         * @description What is wrong with a draft, and where: `clauses.KEY` or `terms.NAME`.
         */
        DraftProblem: {
            /** Where */
            where: string;
            /** Message */
            message: string;
        };
        /**
         * DraftSave
         * @description The draft to save, and the version that it was made from.
         */
        DraftSave: {
            /** Title */
            title: string;
            /** Clauses */
            clauses: components["schemas"]["ClauseRow"][];
            /** Terms */
            terms: {
                [key: string]: number | string;
            };
            /** Currency */
            currency: string;
            /** @default per_cue */
            release_clause: components["schemas"]["ReleaseClause"];
            /**
             * Holdback Bp
             * @default 0
             */
            holdback_bp: number;
            /**
             * Note
             * @default
             */
            note: string;
            /** Based On Version */
            based_on_version: number;
        };
        /**
         * DryStemRead
         * @description A sound without its reverb; the takes of its name are compared with it.
         */
        DryStemRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /**
             * Project Id
             * Format: uuid
             */
            project_id: string;
            /**
             * Delivery Id
             * Format: uuid
             */
            delivery_id: string;
            /**
             * Stem
             * @description Of the takes that it is for: their file names without the ending.
             */
            stem: string;
            /**
             * Take Ids
             * @description The takes that it is for; none while they have not come.
             */
            take_ids: string[];
            /** File Name */
            file_name: string;
            /** File Bytes */
            file_bytes: number;
            /** Sha256 */
            sha256: string;
            /**
             * Received At
             * Format: date-time
             */
            received_at: string;
        };
        /**
         * DryStemUpload
         * @description A finished upload into a take's delivery that is the take's sound without its reverb.
         */
        DryStemUpload: {
            /**
             * Upload Id
             * Format: uuid
             */
            upload_id: string;
        };
        /**
         * EndAdd
         * @description Why a contract ends.
         */
        EndAdd: {
            /** Reason */
            reason: string;
        };
        /**
         * EndingMay
         * @description What the caller may do about an early end now.
         */
        EndingMay: {
            /** Give Notice */
            give_notice: boolean;
            /** Withdraw */
            withdraw: boolean;
            /** Agree */
            agree: boolean;
        };
        /**
         * EndingRead
         * @description What a contract comes to if it ends early: a forecast, then a statement, then what was settled.
         */
        EndingRead: {
            /**
             * Project Id
             * Format: uuid
             */
            project_id: string;
            /**
             * Contract Id
             * Format: uuid
             */
            contract_id: string;
            /** Title */
            title: string;
            designer: components["schemas"]["PersonBrief"];
            /** Currency */
            currency: string;
            my_party: components["schemas"]["Party"] | null;
            /**
             * State
             * @enum {string}
             */
            state: "forecast" | "notice" | "settled";
            notice: components["schemas"]["NoticeRead"] | null;
            /**
             * Notice Days
             * @description Null: no clause lets one party end it alone.
             */
            notice_days: number | null;
            /** Earliest Ends On */
            earliest_ends_on: string | null;
            deposit_at_end: components["schemas"]["DepositAtEnd"];
            /** Cues */
            cues: components["schemas"]["StatedCueRead"][];
            /** Cues Minor */
            cues_minor: number;
            /** Deposit Minor */
            deposit_minor: number;
            /** Rounds Minor */
            rounds_minor: number;
            /** Extra Minor */
            extra_minor: number;
            /** Days Minor */
            days_minor: number;
            /**
             * Due Now Minor
             * @description What is due without the settlement.
             */
            due_now_minor: number;
            figures: components["schemas"]["FiguresRead"];
            /** Open Points */
            open_points: components["schemas"]["OpenPointRead"][];
            /**
             * Statement Sha256
             * @description Null while it is a forecast.
             */
            statement_sha256: string | null;
            /** Settled At */
            settled_at: string | null;
            /** Signed */
            signed: components["schemas"]["SignedRead"][];
            may: components["schemas"]["EndingMay"];
        };
        /**
         * EngagementChange
         * @description Changes; omitted fields stay.
         */
        EngagementChange: {
            kind?: components["schemas"]["EngagementKind"] | null;
            /** Ended */
            ended?: boolean | null;
        };
        /**
         * EngagementKind
         * @description A designer's tie to a project.
         * @enum {string}
         */
        EngagementKind: "advisory" | "contract" | "in-house";
        /**
         * EngagementRead
         * @description A designer's tie to the project.
         */
        EngagementRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            designer: components["schemas"]["PersonBrief"];
            kind: components["schemas"]["EngagementKind"];
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            /** Ended At */
            ended_at: string | null;
            /** Nda Accepted At */
            nda_accepted_at: string | null;
        };
        /**
         * EngineRead
         * @description Effects that the game adds, so files come without them.
         */
        EngineRead: {
            /** Adds */
            adds: string[];
        };
        /**
         * EstimateRead
         * @description An estimate of a cue in minutes, or of a milestone in days; the actual is None until it is done.
         */
        EstimateRead: {
            /**
             * About Id
             * Format: uuid
             */
            about_id: string;
            /** Name */
            name: string;
            /** Estimate */
            estimate: number;
            /** So Far */
            so_far: number;
            /** Actual */
            actual: number | null;
            /** Error Percent */
            error_percent: number | null;
        };
        /**
         * EstimatesRead
         * @description Estimates of cues in minutes and of milestones in days, against actual values.
         */
        EstimatesRead: {
            /** Cues */
            cues: components["schemas"]["EstimateRead"][];
            /** Milestones */
            milestones: components["schemas"]["EstimateRead"][];
            cue_habit: components["schemas"]["HabitRead"];
            milestone_habit: components["schemas"]["HabitRead"];
            /** Forecasts */
            forecasts: components["schemas"]["ForecastRead"][];
            /** Warning */
            warning: string | null;
        };
        /**
         * ExtraRoundRead
         * @description A round beyond the included ones, and its price.
         */
        ExtraRoundRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /**
             * Contract Id
             * Format: uuid
             */
            contract_id: string;
            cue: components["schemas"]["ContractedCue"];
            /** Number */
            number: number;
            /** Included */
            included: number;
            /** Amount Minor */
            amount_minor: number;
            /** Currency */
            currency: string;
            /**
             * State
             * @enum {string}
             */
            state: "proposed" | "agreed" | "dropped";
            /**
             * Proposed At
             * Format: date-time
             */
            proposed_at: string;
        };
        /**
         * Fact
         * @description What a designer may have to know.
         * @enum {string}
         */
        Fact: "source" | "material" | "size" | "surface" | "place" | "distance" | "intensity" | "mood" | "loop" | "length";
        /**
         * FactAnswer
         * @description An answer, which is written into the cue's description.
         */
        FactAnswer: {
            /** Text */
            text: string;
        };
        /**
         * FactDismissal
         * @description Whether a fact is asked for no more.
         */
        FactDismissal: {
            /** Dismissed */
            dismissed: boolean;
        };
        /**
         * FactQuestion
         * @description A fact that a cue's words leave open.
         */
        FactQuestion: {
            fact: components["schemas"]["Fact"];
            /**
             * Question
             * @description In words: How big?
             */
            question: string;
            /**
             * Answers
             * @description Likely answers to choose from; any other is as good.
             */
            answers: string[];
        };
        /**
         * FeedbackAdd
         * @description A word that goes with all the drafts.
         */
        FeedbackAdd: {
            /**
             * Note
             * @default
             */
            note: string;
        };
        /**
         * FeedbackRead
         * @description One consolidated set of notes that went to designers.
         */
        FeedbackRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Note */
            note: string;
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            /** Change Requests */
            change_requests: components["schemas"]["ChangeRequestRead"][];
            /** Rounds */
            rounds: components["schemas"]["RoundRead"][];
            /** Held Back */
            held_back: components["schemas"]["HeldBack"][];
        };
        /**
         * FieldChange
         * @description One fact before and after.
         */
        FieldChange: {
            /** Field */
            field: string;
            /** Before */
            before: unknown;
            /** After */
            after: unknown;
        };
        /**
         * FieldProblem
         * @description The error of one field or one row of a request.
         */
        FieldProblem: {
            /** Where */
            where: string;
            /** Message */
            message: string;
        };
        /**
         * FiguresRead
         * @description What a contract comes to without tax; paid, due, open and saved add up to agreed.
         */
        FiguresRead: {
            /** Agreed Minor */
            agreed_minor: number;
            /** Accepted Minor */
            accepted_minor: number;
            /** Paid Minor */
            paid_minor: number;
            /** Due Minor */
            due_minor: number;
            /** Open Minor */
            open_minor: number;
            /** Saved Minor */
            saved_minor: number;
        };
        /**
         * FindResult
         * @description The results of a search, best first.
         */
        FindResult: {
            /** Hits */
            hits: components["schemas"]["Found"][];
        };
        /**
         * FindingRead
         * @description One rule that a file breaks, with its proof.
         */
        FindingRead: {
            /** Check */
            check: string;
            /** Code */
            code: string;
            /**
             * Severity
             * @enum {string}
             */
            severity: "error" | "warning";
            /** Message */
            message: string;
            /** Fix */
            fix: string;
            /** Measured */
            measured: number | null;
            /** Limit */
            limit: number | null;
            /** Unit */
            unit: string | null;
            /** Start S */
            start_s: number | null;
            /** End S */
            end_s: number | null;
            /** Waived */
            waived: boolean;
            /**
             * Auto Fix
             * @description What a fix does about it; null where none can.
             */
            auto_fix?: string | null;
            /**
             * No Auto Fix
             * @description Why no fix can, and who can put it right.
             */
            no_auto_fix?: string | null;
        };
        /**
         * FitBasis
         * @description The approved sounds that a take is compared with.
         * @enum {string}
         */
        FitBasis: "category" | "palette";
        /**
         * FitPoint
         * @description An approved cue that a sound is compared with; several variations count as the one in their middle.
         */
        FitPoint: {
            cue: components["schemas"]["CueBrief"];
            /** Is Palette */
            is_palette: boolean;
            /** Value */
            value: number;
        };
        /**
         * FixOffer
         * @description A take of which a fix would be enough.
         */
        FixOffer: {
            /**
             * Take Id
             * Format: uuid
             */
            take_id: string;
            cue: components["schemas"]["CueBrief"];
            /** Variation */
            variation: number;
            /** Number */
            number: number;
            take_state: components["schemas"]["TakeState"];
            /**
             * State
             * @enum {string}
             */
            state: "offered" | "making" | "made";
            /**
             * Says
             * @example Trims 45.0 ms from the start.
             */
            says: string;
        };
        /**
         * FixRead
         * @description The possible or finished fix of a take.
         */
        FixRead: {
            /**
             * Take Id
             * Format: uuid
             */
            take_id: string;
            /**
             * State
             * @enum {string}
             */
            state: "none" | "offered" | "making" | "made" | "refused" | "used";
            /**
             * Says
             * @description What the fix does, or did; else why there is none.
             */
            says: string;
            /** Repairs */
            repairs: components["schemas"]["RepairRead"][];
            /** Left */
            left: components["schemas"]["LeftRead"][];
            /**
             * Is Our Fault
             * @description It failed because of an error in our code; asking again may help.
             */
            is_our_fault: boolean;
            /**
             * Before
             * @description Figures of the take, by name.
             */
            before: {
                [key: string]: unknown;
            };
            /**
             * After
             * @description The same figures of the fixed copy.
             */
            after: {
                [key: string]: unknown;
            };
            /**
             * Cut Head S
             * @description Removed from the start.
             */
            cut_head_s: number;
            /**
             * Cut Tail S
             * @description Removed from the end.
             */
            cut_tail_s: number;
            /**
             * Duration S
             * @description Of the fixed copy.
             */
            duration_s: number | null;
            /** File Name */
            file_name: string | null;
            /** Spots */
            spots: components["schemas"]["SpotRead"][];
            /**
             * Becomes
             * @description The version that it would be now, or is.
             */
            becomes: number | null;
            /** New Take Id */
            new_take_id: string | null;
            used_by: components["schemas"]["PersonBrief"] | null;
            /** Used At */
            used_at: string | null;
            fixed_from: components["schemas"]["FixedFrom"] | null;
        };
        /**
         * FixedFrom
         * @description The take that this one is a fix of.
         */
        FixedFrom: {
            /**
             * Take Id
             * Format: uuid
             */
            take_id: string;
            /** Number */
            number: number | null;
            /** Repairs */
            repairs: components["schemas"]["RepairRead"][];
            used_by: components["schemas"]["PersonBrief"];
            /**
             * Used At
             * Format: date-time
             */
            used_at: string;
        };
        /**
         * FollowUpAdd
         * @description What a designer asks about a question of the brief.
         */
        FollowUpAdd: {
            /** Question */
            question: string;
            /** Text */
            text: string;
        };
        /**
         * FollowUpAnswer
         * @description The team's answer.
         */
        FollowUpAnswer: {
            /** Text */
            text: string;
        };
        /**
         * FollowUpRead
         * @description What a designer asks about a question of the brief, and the team's answer.
         */
        FollowUpRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Question */
            question: string;
            /** Text */
            text: string;
            /** @description Null where a designer looks at another designer's follow-up. */
            asked_by: components["schemas"]["PersonBrief"] | null;
            /**
             * Asked At
             * Format: date-time
             */
            asked_at: string;
            /** Answer */
            answer: string | null;
            answered_by: components["schemas"]["PersonBrief"] | null;
            /** Answered At */
            answered_at: string | null;
        };
        /**
         * ForecastRead
         * @description The day that a steady habit makes of a milestone's date.
         */
        ForecastRead: {
            /**
             * Milestone Id
             * Format: uuid
             */
            milestone_id: string;
            /** Milestone */
            milestone: string;
            /**
             * Due On
             * Format: date
             */
            due_on: string;
            /**
             * Forecast On
             * Format: date
             */
            forecast_on: string;
        };
        /**
         * Found
         * @description One hit of the search.
         */
        Found: {
            /**
             * Kind
             * @enum {string}
             */
            kind: "cue" | "file" | "person" | "contract" | "comment" | "question";
            /** Title */
            title: string;
            /**
             * Text
             * @description Its use, its state, an address, or the words in which the typed ones were found.
             */
            text: string;
            /** @description Null for people, contracts and files without a cue. */
            cue?: components["schemas"]["CueBrief"] | null;
            /** Take Id */
            take_id?: string | null;
            /** Contract Id */
            contract_id?: string | null;
            /** Start S */
            start_s?: number | null;
        };
        /**
         * GameFile
         * @description One approved game file of a target.
         */
        GameFile: {
            /**
             * Path
             * @description In the game: the target's folder and the name that the cue owns.
             */
            path: string;
            /** Sha256 */
            sha256: string;
            /** Bytes */
            bytes: number;
            /**
             * Sound
             * @description Equal for two files with the same samples, format and loop.
             */
            sound: string;
            /**
             * Cue
             * @description The number of its cue, as in SW-014.
             */
            cue: string;
            /** Cue Name */
            cue_name: string;
            /**
             * Take Id
             * Format: uuid
             */
            take_id: string;
            /**
             * Url
             * @description Where it is downloaded, by Range where a download was cut.
             */
            url: string;
        };
        /**
         * GameFileOrigin
         * @description Where a game file comes from: cue, approval, contract, sources.
         */
        GameFileOrigin: {
            /** Path */
            path: string;
            /** Target */
            target: string;
            /** Cue */
            cue: string;
            /** Cue Name */
            cue_name: string;
            /** Variation */
            variation: number;
            /** Version */
            version: number | null;
            /**
             * Take Id
             * Format: uuid
             */
            take_id: string;
            /**
             * Is Current
             * @description Whether it is the accepted version now.
             */
            is_current: boolean;
            /**
             * Spec Version
             * @description The newest version of the delivery spec.
             */
            spec_version: number;
            /** Approved By */
            approved_by: string;
            /** Approved On */
            approved_on: string;
            /** Designer */
            designer: string;
            /**
             * Contract
             * @description Title and day of the contract that pays it, or why there is none.
             */
            contract: string;
            /** From Scratch */
            from_scratch: string;
            /** Own Recordings */
            own_recordings: string;
            /**
             * Libraries
             * @description Library files with their licences.
             */
            libraries: string;
            /** Generated */
            generated: string;
            /** Performers */
            performers: string;
            /** Note */
            note: string;
            /** Open Points */
            open_points: string;
            /** Master */
            master: string;
            /** Master Sha256 */
            master_sha256: string;
        };
        /**
         * GameFilesRead
         * @description What `soundlist pull` makes a folder equal to.
         */
        GameFilesRead: {
            /**
             * Project Id
             * Format: uuid
             */
            project_id: string;
            /** Project */
            project: string;
            /** Target */
            target: string;
            /** Spec Version */
            spec_version: number;
            /** Files */
            files: components["schemas"]["GameFile"][];
            /**
             * Missing
             * @description Accepted sounds without a game file that may be downloaded.
             */
            missing: components["schemas"]["OpenGameFile"][];
            /**
             * Placeholders
             * @description Files without an accepted sound, or marked as placeholders.
             */
            placeholders: components["schemas"]["OpenGameFile"][];
        };
        /**
         * GeneratedSource
         * @description A part of a sound that a machine generated.
         */
        GeneratedSource: {
            /**
             * Tool
             * @description Name and version.
             */
            tool: string;
            /**
             * Part
             * @description The part of the sound that it made.
             */
            part: string;
        };
        /** HTTPValidationError */
        HTTPValidationError: {
            /** Detail */
            detail?: components["schemas"]["ValidationError"][];
        };
        /**
         * Habit
         * @description How far a person's estimates can be trusted once corrected by their error rate.
         * @enum {string}
         */
        Habit: "unknown" | "steady" | "wild";
        /**
         * HabitRead
         * @description How estimates turn out: mean error in percent, its spread in points, and what that is good for.
         */
        HabitRead: {
            /** Pairs */
            pairs: number;
            /** Mean Percent */
            mean_percent: number | null;
            /** Spread Points */
            spread_points: number | null;
            habit: components["schemas"]["Habit"];
        };
        /**
         * Handoff
         * @description The engine or middleware whose import files a pack contains.
         * @enum {string}
         */
        Handoff: "none" | "wwise" | "fmod" | "unity" | "unreal" | "godot";
        /**
         * HeldBack
         * @description A draft that could not be sent now, and stays a draft.
         */
        HeldBack: {
            /**
             * Change Request Id
             * Format: uuid
             */
            change_request_id: string;
            /**
             * Take Id
             * Format: uuid
             */
            take_id: string;
            /** Why */
            why: string;
        };
        /**
         * HistoryEntry
         * @description One thing that happened to a take.
         */
        HistoryEntry: {
            /**
             * At
             * Format: date-time
             */
            at: string;
            /**
             * Kind
             * @enum {string}
             */
            kind: "received" | "checked" | "waived" | "approve" | "set_aside" | "request_change" | "withdraw" | "comment";
            by: components["schemas"]["PersonBrief"] | null;
            /** @description The approver whose deputy decided. */
            on_behalf_of?: components["schemas"]["PersonBrief"] | null;
            /**
             * By Deemed Acceptance
             * @description Whether a clause on silence approved it; then nobody did.
             * @default false
             */
            by_deemed_acceptance: boolean;
            /** Text */
            text: string;
            /** Start S */
            start_s?: number | null;
            /** End S */
            end_s?: number | null;
        };
        /**
         * HolidayAdd
         * @description A day on which a studio does not work.
         */
        HolidayAdd: {
            /**
             * Day
             * Format: date
             */
            day: string;
            /** Name */
            name: string;
        };
        /**
         * HolidayRead
         * @description A day on which a studio does not work.
         */
        HolidayRead: {
            /**
             * Day
             * Format: date
             */
            day: string;
            /** Name */
            name: string;
            /**
             * Created At
             * Format: date-time
             * @description Cues that waited before are not delayed by it.
             */
            created_at: string;
        };
        /**
         * ImportAsk
         * @description A spreadsheet, and how to read it.
         */
        ImportAsk: {
            /**
             * Format
             * @enum {string}
             */
            format: "csv" | "xlsx" | "paste";
            /**
             * Content Base64
             * @description The file's bytes; for csv and xlsx.
             */
            content_base64?: string | null;
            /**
             * Text
             * @description What was pasted, or a CSV as text.
             */
            text?: string | null;
            /**
             * Mapping
             * @description Column → field; `extra` keeps a column as it is, `ignore` leaves it out. Columns not named here are read as guessed.
             */
            mapping?: {
                [key: string]: "number" | "name" | "file_name" | "category" | "description" | "use" | "trigger" | "duration_s" | "length_locked" | "frame_rate_fps" | "loop" | "reverb" | "variations" | "state" | "playback_priority" | "due_on" | "placeholder" | "palette" | "extra" | "ignore";
            } | null;
            /**
             * Dry Run
             * @description Only say what would happen.
             */
            dry_run: boolean;
            /**
             * Match
             * @description How a row finds its cue: by number, by name, or never, so that every row is added.
             * @default number
             * @enum {string}
             */
            match: "number" | "name" | "add";
        };
        /**
         * ImportColumn
         * @description A column of the sheet, and what it is read as.
         */
        ImportColumn: {
            /** Name */
            name: string;
            /** Samples */
            samples: string[];
            /**
             * Guess
             * @description What its head and cells look like; null: nothing we know.
             */
            guess: ("number" | "name" | "file_name" | "category" | "description" | "use" | "trigger" | "duration_s" | "length_locked" | "frame_rate_fps" | "loop" | "reverb" | "variations" | "state" | "playback_priority" | "due_on" | "placeholder" | "palette" | "extra" | "ignore") | null;
            /**
             * Field
             * @enum {string}
             */
            field: "number" | "name" | "file_name" | "category" | "description" | "use" | "trigger" | "duration_s" | "length_locked" | "frame_rate_fps" | "loop" | "reverb" | "variations" | "state" | "playback_priority" | "due_on" | "placeholder" | "palette" | "extra" | "ignore";
        };
        /**
         * ImportFault
         * @description The error in one cell.
         */
        ImportFault: {
            /** Row */
            row: number;
            /**
             * Name
             * @description The cue's name as the row has it; empty where it has none.
             */
            name: string;
            /** Column */
            column: string | null;
            /** Message */
            message: string;
        };
        /**
         * ImportRead
         * @description The content of a sheet, its errors, and whether it was imported: all of it or nothing.
         */
        ImportRead: {
            /** Header Row */
            header_row: number | null;
            /** Columns */
            columns: components["schemas"]["ImportColumn"][];
            /** Rows */
            rows: components["schemas"]["ImportRow"][];
            /** Errors */
            errors: components["schemas"]["ImportFault"][];
            /** Added */
            added: number;
            /** Changed */
            changed: number;
            /** Same */
            same: number;
            /** Imported */
            imported: boolean;
            /** Revision */
            revision: number;
        };
        /**
         * ImportRow
         * @description The result for one row.
         */
        ImportRow: {
            /**
             * Row
             * @description Its number in the sheet, as the spreadsheet shows it.
             */
            row: number;
            /**
             * Action
             * @enum {string}
             */
            action: "add" | "change" | "same";
            /**
             * Label
             * @description The cue it changes, or the number it will get; null when we number it.
             */
            label: string | null;
            /** Name */
            name: string;
            /** File Name */
            file_name: string;
            /** Category */
            category: string;
            /** Description */
            description: string;
            /** Duration S */
            duration_s: number | null;
            /** Loop */
            loop: boolean;
            /** Variations */
            variations: number;
            state: components["schemas"]["CueState"];
            /** Due On */
            due_on: string | null;
            /** Changes */
            changes: components["schemas"]["FieldChange"][];
        };
        /**
         * InvitationAccept
         * @description For a new account: name and password. For an account that is not signed in: its password.
         */
        InvitationAccept: {
            /** Name */
            name?: string | null;
            /** Password */
            password?: string | null;
        };
        /**
         * InvitationAccepted
         * @description The tie that accepting made, and to what.
         */
        InvitationAccepted: {
            person: components["schemas"]["PersonRead"];
            /**
             * Project Id
             * Format: uuid
             */
            project_id: string;
            engagement: components["schemas"]["EngagementRead"];
        };
        /**
         * InvitationAdd
         * @description Whom to invite, by what tie.
         */
        InvitationAdd: {
            /** Email */
            email: string;
            /** @default contract */
            kind: components["schemas"]["EngagementKind"];
            /**
             * Note
             * @default
             */
            note: string;
        };
        /**
         * InvitationPreview
         * @description The page of a mailed link: the project, its list, and the required format of sounds.
         */
        InvitationPreview: {
            project: components["schemas"]["PreviewProject"];
            /** Studio Name */
            studio_name: string;
            kind: components["schemas"]["EngagementKind"];
            /** Note */
            note: string;
            /** Email */
            email: string;
            /** Invited By Name */
            invited_by_name: string;
            /** Has Account */
            has_account: boolean;
            /**
             * Expires At
             * Format: date-time
             */
            expires_at: string;
            /**
             * Nda Needed
             * @description An NDA comes first: cues and spec open once it is accepted.
             */
            nda_needed: boolean;
            /** Cues */
            cues: components["schemas"]["PreviewCue"][];
            /** Accepted */
            accepted: boolean;
            spec: components["schemas"]["ResolvedSpec"] | null;
        };
        /**
         * InvitationRead
         * @description An invitation of a designer, and whether it was accepted.
         */
        InvitationRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Email */
            email: string;
            kind: components["schemas"]["EngagementKind"];
            /** Note */
            note: string;
            inviter: components["schemas"]["PersonBrief"];
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            /**
             * Expires At
             * Format: date-time
             */
            expires_at: string;
            /** Accepted At */
            accepted_at: string | null;
        };
        /**
         * InvoiceDraft
         * @description What an invoice would say if it were issued now.
         */
        InvoiceDraft: {
            /**
             * Contract Id
             * Format: uuid
             */
            contract_id: string;
            /** Currency */
            currency: string;
            /** Number */
            number: number;
            /** Full Number */
            full_number: string;
            /** Number Advice */
            number_advice: string;
            /** Is Number Taken */
            is_number_taken: boolean;
            /** Seller */
            seller: string;
            /** Buyer */
            buyer: string;
            /** Po Number */
            po_number: string;
            /** Reverse Charge */
            reverse_charge: boolean;
            /** Payment Days */
            payment_days: number;
            /** Lines */
            lines: components["schemas"]["InvoiceLineRead"][];
            /** Taxes */
            taxes: components["schemas"]["TaxRead"][];
            /** Net Minor */
            net_minor: number;
            /** Total Minor */
            total_minor: number;
        };
        /**
         * InvoiceIssue
         * @description Number, sender and recipient; the lines are everything that is due and on no invoice yet.
         *
         *     Without a number the invoice gets the one after the designer's last.
         */
        InvoiceIssue: {
            /**
             * Full Number
             * @default
             */
            full_number: string;
            /** Seller */
            seller: string;
            /**
             * Buyer
             * @default
             */
            buyer: string;
            /**
             * Po Number
             * @default
             */
            po_number: string;
            /**
             * Note
             * @default
             */
            note: string;
        };
        /**
         * InvoiceLineRead
         * @description One line of an invoice.
         */
        InvoiceLineRead: {
            /** Text */
            text: string;
            /** Amount Minor */
            amount_minor: number;
            /** Tax Bp */
            tax_bp: number | null;
        };
        /**
         * InvoiceRead
         * @description An invoice with its lines and what was paid on it.
         */
        InvoiceRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /**
             * Contract Id
             * Format: uuid
             */
            contract_id: string;
            /** Number */
            number: number;
            /** Full Number */
            full_number: string;
            /** Currency */
            currency: string;
            /**
             * Issued On
             * Format: date
             */
            issued_on: string;
            /**
             * Due On
             * Format: date
             */
            due_on: string;
            /** Seller */
            seller: string;
            /** Buyer */
            buyer: string;
            /** Po Number */
            po_number: string;
            /** Note */
            note: string;
            /** Reverse Charge */
            reverse_charge: boolean;
            /** Lines */
            lines: components["schemas"]["InvoiceLineRead"][];
            /** Taxes */
            taxes: components["schemas"]["TaxRead"][];
            /** Net Minor */
            net_minor: number;
            /** Total Minor */
            total_minor: number;
            /** Paid Minor */
            paid_minor: number;
            /** Open Minor */
            open_minor: number;
            /**
             * State
             * @enum {string}
             */
            state: "open" | "partly_paid" | "paid" | "late";
            /** Days To Pay */
            days_to_pay: number | null;
            /**
             * Late Interest Minor
             * @description What it bears by today, by the contract's clause on late payment.
             */
            late_interest_minor: number;
            /**
             * Late Interest Charged Minor
             * @description What of it is charged already.
             */
            late_interest_charged_minor: number;
            /** Payments */
            payments: components["schemas"]["PaymentRead"][];
        };
        /**
         * JobCountRead
         * @description The number of jobs of one name in one state.
         */
        JobCountRead: {
            /** Job */
            job: string;
            state: components["schemas"]["JobState"];
            /** Jobs */
            jobs: number;
            /**
             * Oldest At
             * Format: date-time
             */
            oldest_at: string;
        };
        /**
         * JobRead
         * @description One job that waits, runs or gave up.
         */
        JobRead: {
            /** Id */
            id: string;
            /**
             * Job
             * @example renders.prepare_take
             */
            job: string;
            /**
             * Studio Id
             * @description Whose work it is; null for what concerns one person's account alone.
             */
            studio_id: string | null;
            /** Studio Name */
            studio_name: string | null;
            state: components["schemas"]["JobState"];
            /** Tries */
            tries: number;
            /**
             * Since
             * Format: date-time
             */
            since: string;
            /**
             * Reason
             * @description The last failure. A producer sees the kind of failure, an operator the details.
             */
            reason: string | null;
        };
        /**
         * JobState
         * @description The state of an unfinished job; done ones are not listed.
         * @enum {string}
         */
        JobState: "parked" | "running" | "waiting" | "delayed" | "broken";
        /**
         * JoinedStudio
         * @description A person who joined a studio.
         */
        JoinedStudio: {
            person: components["schemas"]["PersonRead"];
            studio: components["schemas"]["StudioBrief"];
        };
        /**
         * KeptFiles
         * @description The number of stored files of one kind, and their total size.
         */
        KeptFiles: {
            kind: components["schemas"]["KeptKind"];
            /** Files */
            files: number;
            /** Size Bytes */
            size_bytes: number;
        };
        /**
         * KeptKind
         * @description The kind of a stored file.
         * @enum {string}
         */
        KeptKind: "masters" | "dry_stems" | "archives" | "game_files" | "drawings" | "fixes" | "reels" | "exports" | "placeholder_files" | "documents";
        /**
         * KitRead
         * @description A kind of game to start a list from.
         */
        KitRead: {
            /** Key */
            key: string;
            /** Name */
            name: string;
            /** About */
            about: string;
            /** Cues */
            cues: number;
            /**
             * Files
             * @description Variations counted.
             */
            files: number;
            /**
             * Categories
             * @description Cues by category.
             */
            categories: {
                [key: string]: number;
            };
            usual_cues: components["schemas"]["UsualRange"];
            usual_hours: components["schemas"]["UsualRange"];
            usual_memory_mb: components["schemas"]["UsualRange"];
        };
        /**
         * KitRow
         * @description A cue of a kit as it would be added, under the name that the project's spec asks for.
         */
        KitRow: {
            /** Name */
            name: string;
            /** File Name */
            file_name: string;
            /** Category */
            category: string;
            /** Description */
            description: string;
            /** Use */
            use: string;
            /** Duration S */
            duration_s: number;
            /** Loop */
            loop: boolean;
            /** Variations */
            variations: number;
            /**
             * Is Listed
             * @description The list has a cue with this file name already.
             */
            is_listed: boolean;
        };
        /**
         * KitRows
         * @description The cues of a kit, for one project.
         */
        KitRows: {
            /** Key */
            key: string;
            /** Name */
            name: string;
            /** Rows */
            rows: components["schemas"]["KitRow"][];
        };
        /**
         * LaneRead
         * @description The jobs of one studio and one urgency; lanes take turns.
         */
        LaneRead: {
            /**
             * Studio Id
             * @description Null for what is done on no studio's behalf.
             */
            studio_id: string | null;
            /** Studio Name */
            studio_name: string | null;
            urgency: components["schemas"]["Urgency"];
            /** Waiting */
            waiting: number;
            /** Running */
            running: number;
            /**
             * Delayed
             * @description Failed, and to be tried again later.
             */
            delayed: number;
            /**
             * Oldest At
             * @description Since when the one waits that has waited longest.
             */
            oldest_at: string | null;
        };
        /**
         * LastContract
         * @description A contract to begin like.
         */
        LastContract: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Title */
            title: string;
            designer: components["schemas"]["PersonBrief"];
            /** Currency */
            currency: string;
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
        };
        /**
         * LastContractRead
         * @description The contract that another one can begin like; null where the studio has sent none of its kind.
         */
        LastContractRead: {
            contract: components["schemas"]["LastContract"] | null;
        };
        /**
         * LastReadRead
         * @description Which version a designer opened last.
         */
        LastReadRead: {
            designer: components["schemas"]["PersonBrief"];
            /**
             * Version
             * @description Null: none yet.
             */
            version: number | null;
            /** Read At */
            read_at: string | null;
            /**
             * Behind
             * @description How many versions are newer.
             */
            behind: number;
        };
        /**
         * LedgerLineRead
         * @description One line of a ledger: why, how much, by which clause, for which cue, and whose act it follows.
         */
        LedgerLineRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /**
             * At
             * Format: date-time
             */
            at: string;
            kind: components["schemas"]["LineKind"];
            /** Amount Minor */
            amount_minor: number;
            /** Clause */
            clause: string;
            cue: components["schemas"]["ContractedCue"] | null;
            /** Milestone Id */
            milestone_id: string | null;
            /** Milestone */
            milestone: string | null;
            /** Round Number */
            round_number: number | null;
            /** Tax Bp */
            tax_bp: number | null;
            /** By */
            by: string;
            /** About Id */
            about_id: string | null;
            /** Invoice Id */
            invoice_id: string | null;
            /** Invoice Number */
            invoice_number: string | null;
            /** Reference */
            reference: string | null;
        };
        /**
         * LedgerRead
         * @description A contract's ledger in the order of its writing, and what it comes to.
         */
        LedgerRead: {
            /**
             * Contract Id
             * Format: uuid
             */
            contract_id: string;
            /** Currency */
            currency: string;
            figures: components["schemas"]["FiguresRead"];
            /** Tax Minor */
            tax_minor: number;
            /** Open Tax Minor */
            open_tax_minor: number;
            bonus: components["schemas"]["BonusRead"] | null;
            /** Lines */
            lines: components["schemas"]["LedgerLineRead"][];
        };
        /**
         * LeftRead
         * @description A finding that remains in a fixed copy, and why no fix answers it.
         */
        LeftRead: {
            /** Code */
            code: string;
            /**
             * Severity
             * @enum {string}
             */
            severity: "error" | "warning";
            /** Message */
            message: string;
            /** Why */
            why: string;
        };
        /**
         * LibraryClauseRead
         * @description A clause of the library, and why one would want it.
         */
        LibraryClauseRead: {
            /** Key */
            key: string;
            /** Title */
            title: string;
            /** Text */
            text: string;
            /** Stands */
            stands: boolean;
            /** Why */
            why: string;
            /** Music */
            music: boolean;
            /** Instead Of */
            instead_of: string | null;
            /** Terms */
            terms: components["schemas"]["TermRead"][];
        };
        /**
         * LibraryRead
         * @description What the library has for a kind of contract, and the variables that the server fills in.
         */
        LibraryRead: {
            kind: components["schemas"]["ContractKind"];
            /** Notice */
            notice: string;
            /** Clauses */
            clauses: components["schemas"]["LibraryClauseRead"][];
            /** Variables */
            variables: {
                [key: string]: string;
            };
        };
        /**
         * LibrarySource
         * @description A sound library that a sound has layers from.
         */
        LibrarySource: {
            /** Name */
            name: string;
            /**
             * Licence
             * @description Its name, or where it is kept; empty: not known yet.
             * @default
             */
            licence: string;
            /**
             * File
             * @description The recording of the library.
             * @default
             */
            file: string;
        };
        /**
         * LimitsRead
         * @description The levels and edges a file keeps to; null does not limit.
         */
        LimitsRead: {
            /** Sample Peak Dbfs */
            sample_peak_dbfs: number | null;
            /** True Peak Dbtp */
            true_peak_dbtp: number | null;
            /** Dc Offset Percent */
            dc_offset_percent: number | null;
            /** Silence Below Dbfs */
            silence_below_dbfs: number | null;
            /** Head Silence Ms */
            head_silence_ms: number | null;
            /** Tail Silence Ms */
            tail_silence_ms: number | null;
            /** Edge Silence Below Dbfs */
            edge_silence_below_dbfs: number;
            /** Tolerance Db */
            tolerance_db: number;
            loudness_lufs: components["schemas"]["RangeRead"];
            /** Noise Floor Dbfs */
            noise_floor_dbfs: number | null;
            /** Mono Loss Db */
            mono_loss_db: number | null;
            /**
             * Others
             * @description Limits of checks that are named by `/v1/checks` alone, by key.
             */
            others: {
                [key: string]: number;
            };
        };
        /**
         * LineKind
         * @description Why a line of the ledger was written.
         * @enum {string}
         */
        LineKind: "deposit" | "accepted" | "held_back" | "cut" | "extra_round" | "worked_day" | "extra_work" | "late_interest" | "bonus" | "tax" | "reversed" | "paid" | "refunded";
        /**
         * ListComparison
         * @description The changes of the list between two revisions.
         */
        ListComparison: {
            /** From Revision */
            from_revision: number;
            /** To Revision */
            to_revision: number;
            /** Added */
            added: components["schemas"]["CueDifference"][];
            /** Changed */
            changed: components["schemas"]["CueDifference"][];
            /** Cut */
            cut: components["schemas"]["CueDifference"][];
        };
        /**
         * ListCounts
         * @description The numbers of cues of the whole list by status.
         */
        ListCounts: {
            /** Counts */
            counts: {
                [key: string]: number;
            };
            /** Files To Review */
            files_to_review: number;
        };
        /**
         * ListProgress
         * @description The progress of the cues of one page of the list; `next` is the cursor of the following page, null at the end.
         */
        ListProgress: {
            /** Cues */
            cues: components["schemas"]["CueProgress"][];
            /** Next */
            next: string | null;
        };
        /**
         * LossLevels
         * @description Levels of one sound, named as in the report; null is silence.
         */
        LossLevels: {
            /** Sample Peak Dbfs */
            sample_peak_dbfs?: number | null;
            /** True Peak Dbtp */
            true_peak_dbtp?: number | null;
            /** Short Loudness Lufs */
            short_loudness_lufs?: number | null;
            /** Integrated Lufs */
            integrated_lufs?: number | null;
        } & {
            [key: string]: unknown;
        };
        /**
         * LossRead
         * @description What a game file lost against its master; null in dB means silence.
         */
        LossRead: {
            before: components["schemas"]["LossLevels"];
            after: components["schemas"]["LossLevels"];
            /**
             * Above Nyquist Db
             * @description Energy above half the new rate against all of the master's, in dB.
             */
            above_nyquist_db: number | null;
            /** Shelf Db */
            shelf_db: number;
            /** Attenuation Db */
            attenuation_db: number;
            /**
             * Requantisation Dbfs
             * @description RMS of what rounding and dither added; null: every sample is exact.
             */
            requantisation_dbfs: number | null;
            /**
             * Trimmed S
             * @description At the start, and at the end.
             */
            trimmed_s: number[];
            /** Loop Fit Frames */
            loop_fit_frames: number;
            seam_before: components["schemas"]["SeamRead"] | null;
            seam_after: components["schemas"]["SeamRead"] | null;
            /** Mono Loss Db */
            mono_loss_db: number | null;
            spectra: components["schemas"]["LossSpectra"];
        };
        /**
         * LossSpectra
         * @description Master and game file in the same bands, RMS over the whole sound; null where there is nothing.
         */
        LossSpectra: {
            /** Hz */
            hz: number[];
            /** Master Dbfs */
            master_dbfs: (number | null)[];
            /** Render Dbfs */
            render_dbfs: (number | null)[];
        };
        /**
         * MailRead
         * @description One mail of the studio's outbox.
         */
        MailRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Recipient */
            recipient: string;
            /** Subject */
            subject: string;
            /** Text */
            text: string;
            /** Link */
            link: string | null;
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            /** Sent At */
            sent_at: string | null;
            /** Failure */
            failure: string | null;
        };
        /**
         * Manifest
         * @description The manifest for `audio-checks audit --manifest`.
         */
        Manifest: {
            /**
             * Schema Version
             * @constant
             */
            schema_version: 1;
            tool: components["schemas"]["ManifestTool"];
            /** Fingerprint Version */
            fingerprint_version: number;
            /** Files */
            files: components["schemas"]["ManifestSound"][];
        };
        /**
         * ManifestSound
         * @description One approved game file, and what it is known by.
         */
        ManifestSound: {
            /**
             * Path
             * @description In the pack, and so in the game.
             */
            path: string;
            /** Pcm Sha256 */
            pcm_sha256: string | null;
            /** Sample Rate Hz */
            sample_rate_hz: number;
            /** Bit Depth */
            bit_depth: number | null;
            /** Channels */
            channels: number;
            /** Frames */
            frames: number;
            /**
             * Sample Peak Dbfs
             * @description Null for silence, like the next.
             */
            sample_peak_dbfs: number | null;
            /** Rms Dbfs */
            rms_dbfs: number | null;
            /**
             * Fingerprint
             * @description Base64; null where there is nothing to know it by.
             */
            fingerprint: string | null;
            /**
             * Cue
             * @description The number of its cue.
             */
            cue: string | null;
            /**
             * Take
             * @description The id of its take.
             */
            take: string | null;
        };
        /**
         * ManifestTool
         * @description The tool that made the manifest.
         */
        ManifestTool: {
            /**
             * Name
             * @constant
             */
            name: "audio-checks";
            /** Version */
            version: string;
        };
        /**
         * MarkedClauseRead
         * @description A clause of the text that both read, with what is struck and inserted as marks.
         */
        MarkedClauseRead: {
            /** Key */
            key: string;
            /**
             * Number
             * @description In the version that was sent; null for an inserted clause.
             */
            number: number | null;
            /** Lines */
            lines: components["schemas"]["ComparedRead"][];
            /**
             * Counter Lines
             * @description The studio's counter, against the version that was sent.
             */
            counter_lines: components["schemas"]["ComparedRead"][];
            redline: components["schemas"]["RedlineRead"] | null;
        };
        /**
         * MasterExportRead
         * @description A take's master with what is known of it written into bext and iXML; its sound is the master's, byte for byte.
         */
        MasterExportRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /**
             * Take Id
             * Format: uuid
             */
            take_id: string;
            /**
             * State
             * @enum {string}
             */
            state: "making" | "made" | "refused";
            /** Refusal */
            refusal: string | null;
            /**
             * Fields
             * @description Its metadata, by the field names of ASWG-G006.
             */
            fields: {
                [key: string]: string;
            };
            /**
             * Left
             * @description What could not be written, as sentences.
             */
            left: string[];
            /** File Bytes */
            file_bytes: number | null;
            /** File Name */
            file_name: string;
            /** File Url */
            file_url: string | null;
        };
        /**
         * MasterSoundRead
         * @description A take's master, to show and play; its measurements are in its check.
         */
        MasterSoundRead: {
            /** Picture Id */
            picture_id: string | null;
            /** Duration S */
            duration_s: number | null;
            thumb: components["schemas"]["ThumbRead"] | null;
            /** Preview Url */
            preview_url: string | null;
            /** Peaks Url */
            peaks_url: string | null;
            /** Spectrum Url */
            spectrum_url: string | null;
            /**
             * State
             * @enum {string}
             */
            state: "drawn" | "drawing" | "undrawable";
            /** Facts */
            facts: {
                [key: string]: unknown;
            };
            /** File Bytes */
            file_bytes: number;
        };
        /**
         * MayRead
         * @description What the caller may do with the contract now.
         */
        MayRead: {
            /** Change */
            change: boolean;
            /** Send */
            send: boolean;
            /** Recall */
            recall: boolean;
            /** Request Change */
            request_change: boolean;
            /** Accept */
            accept: boolean;
            /** End */
            end: boolean;
            /**
             * Amend
             * @description Whether they may propose a change order, or give notice.
             */
            amend: boolean;
        };
        /**
         * Me
         * @description The signed-in person, and everything they can open.
         */
        Me: {
            person: components["schemas"]["PersonBrief"];
            /** Email */
            email: string;
            /**
             * Email Verified At
             * @description Since when it is known that they read this address.
             */
            email_verified_at: string | null;
            /**
             * Is Operator
             * @description Whether the caller runs this server.
             */
            is_operator: boolean;
            /** Studios */
            studios: components["schemas"]["MyStudio"][];
            /** Projects */
            projects: components["schemas"]["MyProject"][];
        };
        /**
         * Measure
         * @description The measures by which sounds are compared.
         * @enum {string}
         */
        Measure: "loudness" | "spectrum" | "dryness" | "timbre";
        /**
         * MeasureFit
         * @description The position of a sound among others by one measure.
         */
        MeasureFit: {
            measure: components["schemas"]["Measure"];
            /**
             * Unit
             * @description Of loudness LUFS; of spectrum and timbre the dB from the middle of the others.
             */
            unit: string;
            /** Value */
            value: number;
            /**
             * Middle
             * @description Of the others.
             */
            middle: number;
            /** Lowest */
            lowest: number;
            /** Highest */
            highest: number;
            stands: components["schemas"]["Stands"];
            /** Others */
            others: components["schemas"]["FitPoint"][];
        };
        /**
         * MemberRead
         * @description A member of the studio.
         */
        MemberRead: {
            person: components["schemas"]["PersonBrief"];
            /** Email */
            email: string;
            /** Roles */
            roles: components["schemas"]["Role"][];
            /**
             * Since
             * Format: date-time
             */
            since: string;
        };
        /**
         * MemoryByCategory
         * @description The memory of a target, in total and by category.
         */
        MemoryByCategory: {
            total: components["schemas"]["MemoryRead"];
            /** Categories */
            categories: components["schemas"]["MemoryRead"][];
        };
        /**
         * MemoryRead
         * @description The memory of some of a target's files.
         */
        MemoryRead: {
            /** Category */
            category: string | null;
            /** Files */
            files: number;
            /**
             * Unknown Files
             * @description Left out, because their cues have no length yet.
             */
            unknown_files: number;
            /** Pcm Bytes */
            pcm_bytes: number;
            /** Disk Bytes */
            disk_bytes: number;
            /** Memory Bytes */
            memory_bytes: number;
            /** Budget Bytes */
            budget_bytes: number | null;
            /** Over Bytes */
            over_bytes: number | null;
        };
        /**
         * MilestoneCue
         * @description A cue of a milestone, and where it stands.
         */
        MilestoneCue: {
            cue: components["schemas"]["ContractedCue"];
            /** Price Minor */
            price_minor: number | null;
            /** Amount Minor */
            amount_minor: number | null;
            /** Estimate Min */
            estimate_min: number | null;
            /** Accepted At */
            accepted_at: string | null;
            cut_in: components["schemas"]["WorkState"] | null;
            /** Owed Minor */
            owed_minor: number;
            /** Paid Minor */
            paid_minor: number;
            status: components["schemas"]["CueStatus"];
        };
        /**
         * MilestoneCueRead
         * @description A cue under contract: what was agreed for it and what became of it.
         */
        MilestoneCueRead: {
            cue: components["schemas"]["ContractedCue"];
            /** Price Minor */
            price_minor: number | null;
            /** Amount Minor */
            amount_minor: number | null;
            /** Estimate Min */
            estimate_min: number | null;
            /** Accepted At */
            accepted_at: string | null;
            cut_in: components["schemas"]["WorkState"] | null;
            /** Owed Minor */
            owed_minor: number;
            /** Paid Minor */
            paid_minor: number;
        };
        /**
         * MilestoneRead
         * @description A milestone; `left_minor` is its amount without what cuts saved.
         */
        MilestoneRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Name */
            name: string;
            /** Is Deposit */
            is_deposit: boolean;
            /** Amount Minor */
            amount_minor: number;
            /** Left Minor */
            left_minor: number;
            /** Owed Minor */
            owed_minor: number;
            /** Paid Minor */
            paid_minor: number;
            /** Due On */
            due_on: string | null;
            /** Tax Bp */
            tax_bp: number | null;
            /** Accepted */
            accepted: number;
            /** Wanted */
            wanted: number;
            /** Done At */
            done_at: string | null;
            /** Cues */
            cues: components["schemas"]["MilestoneCueRead"][];
        };
        /**
         * MilestoneSet
         * @description A planned milestone; without an amount, the prices of its cues add up to it.
         */
        MilestoneSet: {
            /** Name */
            name: string;
            /** Amount Minor */
            amount_minor?: number | null;
            /** Due On */
            due_on?: string | null;
            /**
             * Is Deposit
             * @default false
             */
            is_deposit: boolean;
            /** Tax Bp */
            tax_bp?: number | null;
            /** Cues */
            cues?: components["schemas"]["PlannedCueSet"][];
        };
        /**
         * MilestoneSheet
         * @description A milestone with all that is known of it; slip and estimates are None but for the two parties.
         */
        MilestoneSheet: {
            /**
             * Project Id
             * Format: uuid
             */
            project_id: string;
            /**
             * Contract Id
             * Format: uuid
             */
            contract_id: string;
            /** Contract Title */
            contract_title: string;
            contract_state: components["schemas"]["ContractState"];
            designer: components["schemas"]["PersonBrief"];
            /** Currency */
            currency: string;
            release: components["schemas"]["ReleaseClause"];
            milestone: components["schemas"]["MilestoneRead"];
            /** Cues */
            cues: components["schemas"]["MilestoneCue"][];
            slip: components["schemas"]["MilestoneSlip"] | null;
            /** Slips */
            slips: components["schemas"]["MilestoneSlip"][];
            /** Slip Growth Days */
            slip_growth_days: number | null;
            estimates: components["schemas"]["EstimatesRead"] | null;
            /** Lines */
            lines: components["schemas"]["LedgerLineRead"][];
            /** Invoices */
            invoices: components["schemas"]["InvoiceRead"][];
        };
        /**
         * MilestoneSlip
         * @description The delay of a milestone in whole days, split by the party that caused it.
         */
        MilestoneSlip: {
            /**
             * Milestone Id
             * Format: uuid
             */
            milestone_id: string;
            /** Name */
            name: string;
            /**
             * Due On
             * Format: date
             */
            due_on: string;
            /** Days */
            days: number;
            /** Designer Days */
            designer_days: number;
            /** Studio Days */
            studio_days: number;
        };
        /**
         * Mine
         * @description The caller's roles in the project.
         */
        Mine: {
            /** Is Team */
            is_team: boolean;
            /** Is Producer */
            is_producer: boolean;
            /** Is Liaison */
            is_liaison: boolean;
            /**
             * Is Approver
             * @description Whether the caller approves some sounds today, as approver or as deputy.
             */
            is_approver: boolean;
            engagement_kind: components["schemas"]["EngagementKind"] | null;
            /**
             * Nda Open
             * @description Brief, list and spec open once the caller has accepted the project's NDA.
             */
            nda_open: boolean;
        };
        /**
         * MissingFile
         * @description An accepted sound that a target has no game file of, and why.
         */
        MissingFile: {
            /**
             * Cue Id
             * Format: uuid
             */
            cue_id: string;
            /** Label */
            label: string;
            /** Name */
            name: string;
            /** File Name */
            file_name: string;
            /** Reason */
            reason: string;
        };
        /**
         * MoveDate
         * @description Another date of a milestone.
         */
        MoveDate: {
            /**
             * @description discriminator enum property added by openapi-typescript
             * @enum {string}
             */
            kind: "move_date";
            /**
             * Milestone Id
             * Format: uuid
             */
            milestone_id: string;
            /**
             * Due On
             * Format: date
             */
            due_on: string;
        };
        /**
         * MyProject
         * @description A project that the caller sees, and what they are in it.
         */
        MyProject: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Name */
            name: string;
            /**
             * Studio Id
             * Format: uuid
             */
            studio_id: string;
            /** Studio Name */
            studio_name: string;
            /** Cue Prefix */
            cue_prefix: string;
            /**
             * Part
             * @enum {string}
             */
            part: "team" | "designer";
            /** Is Producer */
            is_producer: boolean;
            /** Is Liaison */
            is_liaison: boolean;
            /** Is Approver */
            is_approver: boolean;
            /**
             * Approves All
             * @description False for who approves some categories only, or none.
             */
            approves_all: boolean;
            engagement_kind: components["schemas"]["EngagementKind"] | null;
            /**
             * Nda Open
             * @description Brief, list and spec stay closed to the caller until the NDA is agreed.
             */
            nda_open: boolean;
        };
        /**
         * MyStudio
         * @description A studio that the caller is a member of.
         */
        MyStudio: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Name */
            name: string;
            /** Roles */
            roles: components["schemas"]["Role"][];
        };
        /**
         * NameChange
         * @description The name to be.
         */
        NameChange: {
            /** Name */
            name: string;
        };
        /**
         * NameTokenRead
         * @description One part of a name.
         */
        NameTokenRead: {
            /** Name */
            name: string;
            /**
             * Wanted
             * @description What it may be, in words.
             */
            wanted: string;
            /** Optional */
            optional: boolean;
            /** Repeats */
            repeats: boolean;
        };
        /**
         * NamingRead
         * @description The naming of files: by a pattern, by tokens, or by the grammar of the Universal Category System.
         */
        NamingRead: {
            /** Pattern */
            pattern: string | null;
            /** Extension */
            extension: string | null;
            /** Tokens */
            tokens: components["schemas"]["NameTokenRead"][];
            /** Separator */
            separator: string;
            /** Grammar */
            grammar: string | null;
            /**
             * Portable
             * @description Whether names must be such that every system can hold them.
             */
            portable: boolean;
        };
        /**
         * NewPassword
         * @description The password to be.
         */
        NewPassword: {
            /** Password */
            password: string;
        };
        /**
         * NewestTake
         * @description The take that a list row shows.
         */
        NewestTake: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Number */
            number: number;
            /** Variation */
            variation: number;
            /** State */
            state: string;
            /** File Name */
            file_name: string;
            /**
             * Received At
             * Format: date-time
             */
            received_at: string;
            /** Duration S */
            duration_s: number | null;
            /** Thumb */
            thumb: {
                [key: string]: unknown;
            } | null;
            /** Preview Url */
            preview_url: string | null;
        };
        /**
         * NextStep
         * @description Something that the caller is the one to do, and what it is about.
         */
        NextStep: {
            kind: components["schemas"]["NextStepKind"];
            /**
             * Count
             * @default 1
             */
            count: number;
            /**
             * Subject
             * @description A title, an invoice's number or a person's name.
             * @default
             */
            subject: string;
            /**
             * Who
             * @description The other side, where there is one.
             * @default
             */
            who: string;
            /** Since */
            since?: string | null;
            /** Contract Id */
            contract_id?: string | null;
            /** Posting Id */
            posting_id?: string | null;
            /** Amount Minor */
            amount_minor?: number | null;
            /** Currency */
            currency?: string | null;
        };
        /**
         * NextStepKind
         * @description What a person is the one to do, in the order in which it is shown.
         * @enum {string}
         */
        NextStepKind: "add_cues" | "write_brief" | "invite_designer" | "answer_candidates" | "compare_bids" | "send_nda" | "sign_contract" | "change_contract" | "pay_invoice" | "invoice_deposit" | "deposit_due" | "fix" | "match" | "answer_questions" | "answer_follow_ups" | "agree_days" | "agree_round" | "send_changes" | "review" | "send_contract" | "invoice_due" | "name_approver" | "make";
        /**
         * NextSteps
         * @description What the caller is to do in a project, the first thing first, and for whom they wait.
         */
        NextSteps: {
            /** Steps */
            steps: components["schemas"]["NextStep"][];
            /**
             * Awaited
             * @description The longest wait first.
             */
            awaited: components["schemas"]["Awaited"][];
        };
        /**
         * NoteAnswerGive
         * @description Whether a version does what a note on an earlier one asked.
         */
        NoteAnswerGive: {
            /** Is Done */
            is_done: boolean;
        };
        /**
         * NoteAnswerRead
         * @description What was last said of a note that was carried over, of which version, by whom and when.
         */
        NoteAnswerRead: {
            /** Is Done */
            is_done: boolean;
            /**
             * Number
             * @description Of the version that it was said of.
             */
            number: number;
            given_by: components["schemas"]["PersonBrief"];
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
        };
        /**
         * NoticeAdd
         * @description Why a contract ends, and its last day: the earliest that the contract allows where none is given.
         */
        NoticeAdd: {
            /** Reason */
            reason: string;
            /** Ends On */
            ends_on?: string | null;
        };
        /**
         * NoticeRead
         * @description A party's notice.
         */
        NoticeRead: {
            /** Number */
            number: number;
            party: components["schemas"]["Party"];
            /** Given By */
            given_by: string;
            /**
             * Given At
             * Format: date-time
             */
            given_at: string;
            /** Reason */
            reason: string;
            /**
             * Ends On
             * @description Last day; null: it ends only when both agree to the statement.
             */
            ends_on: string | null;
        };
        /**
         * OfferDismiss
         * @description What a party wants no change order for, and why.
         */
        OfferDismiss: {
            /** Offer */
            offer: string;
            /** Reason */
            reason: string;
        };
        /**
         * OfferDismissed
         * @description That the other party wants no change order for it.
         */
        OfferDismissed: {
            party: components["schemas"]["Party"];
            /** By */
            by: string;
            /**
             * At
             * Format: date-time
             */
            at: string;
            /** Reason */
            reason: string;
        };
        /**
         * OfferKind
         * @description What changed since a contract was signed, so that a change order is offered.
         * @enum {string}
         */
        OfferKind: "round" | "described" | "needed" | "spec" | "answered" | "added" | "cut";
        /**
         * OfferedChange
         * @description What the form begins with where a change order is offered; what is null is for the party to say.
         */
        OfferedChange: {
            /**
             * Kind
             * @enum {string}
             */
            kind: "add_cue" | "reprice_cue" | "add_round" | "move_date" | "add_work";
            /** Cue Id */
            cue_id?: string | null;
            /** Milestone Id */
            milestone_id?: string | null;
            /**
             * Text
             * @default
             */
            text: string;
            /** Due On */
            due_on?: string | null;
        };
        /**
         * OpenGameFile
         * @description A file that the game has no final sound for, and why.
         */
        OpenGameFile: {
            /** Path */
            path: string;
            /** Cue */
            cue: string;
            /** Reason */
            reason: string;
        };
        /**
         * OpenPointRead
         * @description Work that the studio has not agreed to yet, so the statement does not count it.
         */
        OpenPointRead: {
            /**
             * Kind
             * @enum {string}
             */
            kind: "round" | "day";
            /** Text */
            text: string;
            /** Amount Minor */
            amount_minor: number;
        };
        /**
         * OrderCue
         * @description A cue under the contract that a change order may name.
         */
        OrderCue: {
            cue: components["schemas"]["ContractedCue"];
            /** Price Minor */
            price_minor: number;
            /**
             * Round Minor
             * @description What a further round of it costs; 0: the contract names no price.
             */
            round_minor: number;
        };
        /**
         * OrderMilestone
         * @description A milestone that a change order may name.
         */
        OrderMilestone: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Name */
            name: string;
            /** Due On */
            due_on: string | null;
        };
        /**
         * OutboxRead
         * @description The studio's mails, and whether a server takes them.
         */
        OutboxRead: {
            /** Can Send */
            can_send: boolean;
            /** Mails */
            mails: components["schemas"]["MailRead"][];
        };
        /**
         * Overview
         * @description A project at one glance.
         */
        Overview: {
            /**
             * Steps
             * @description Of the first 500 cues of the list.
             */
            steps: components["schemas"]["Step"][];
            /** Cues */
            cues: number;
            /** Counts */
            counts: {
                [key: string]: number;
            };
            /** Builds */
            builds: components["schemas"]["BuildBrief"][];
            /** Palette */
            palette: components["schemas"]["PaletteSound"][];
            /** Lately */
            lately: components["schemas"]["Activity"][];
            /** Reviewers */
            reviewers: number;
        };
        /**
         * OwnBidRead
         * @description The caller's own bid.
         */
        OwnBidRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            state: components["schemas"]["BidState"];
            /** Revision */
            revision: number;
            content: components["schemas"]["BidContent"];
            /** Total Minor */
            total_minor: number;
            /**
             * Missing
             * @description Asked lines that it does not offer.
             */
            missing: string[];
            /** Sent At */
            sent_at: string | null;
            /** Resent At */
            resent_at: string | null;
            /**
             * Differs
             * @description Whether the draft differs from what was sent.
             */
            differs: boolean;
            /** Is Awarded */
            is_awarded: boolean;
        };
        /**
         * Pace
         * @description How a project goes: early warnings for both sides; null where too little has happened for a figure.
         */
        Pace: {
            /** Cues */
            cues: number;
            /** Accepted */
            accepted: number;
            /**
             * First Pass
             * @description Share of the decided cues that were accepted as they came first.
             */
            first_pass: number | null;
            /**
             * First Pass Lately
             * @description The same of the last four weeks.
             */
            first_pass_lately: number | null;
            /** First Pass Before */
            first_pass_before: number | null;
            /** Rounds Per Cue */
            rounds_per_cue: number | null;
            /**
             * Days Late
             * @description By which accepted cues missed their day; below zero: early.
             */
            days_late: number | null;
            /** Overdue */
            overdue: number;
            /**
             * Finish On
             * @description At the pace of the last four weeks.
             */
            finish_on: string | null;
            /**
             * Needed On
             * @description The last day on which a cue that is not accepted is needed.
             */
            needed_on: string | null;
            /** Worn */
            worn: components["schemas"]["WornCue"][];
            studio: components["schemas"]["StudioPace"];
            /**
             * Costs
             * @description Of the contracts that the caller is a party to.
             */
            costs: components["schemas"]["CostPerSound"][];
        };
        /**
         * PackAdd
         * @description The pack to seal.
         */
        PackAdd: {
            /** Target */
            target: string;
            /**
             * Note
             * @default
             */
            note: string;
            /**
             * Masters
             * @default false
             */
            masters: boolean;
            /**
             * Allow Missing
             * @description Leave out accepted sounds that have no game file.
             * @default false
             */
            allow_missing: boolean;
            /**
             * Placeholders
             * @description Put marked placeholder files in for the sounds that are not accepted.
             * @default false
             */
            placeholders: boolean;
            /**
             * @description The engine whose import files go with the sounds.
             * @default none
             */
            handoff: components["schemas"]["Handoff"];
        };
        /**
         * PackChanges
         * @description Changes of the game files since an earlier pack of the target; same: the same sound and loop.
         */
        PackChanges: {
            /**
             * Since
             * @description The number of that pack; null where there was none.
             */
            since: number | null;
            /** New */
            new: number;
            /** Changed */
            changed: number;
            /** Gone */
            gone: number;
            /** Same */
            same: number;
            /**
             * Paths
             * @description The first of each kind.
             */
            paths: components["schemas"]["ChangedPath"][];
        };
        /**
         * PackRead
         * @description The content of the approved pack of a target.
         */
        PackRead: {
            /** Target */
            target: string;
            /** Targets */
            targets: string[];
            /** Files */
            files: number;
            /** Bytes */
            bytes: number;
            /** Masters Bytes */
            masters_bytes: number;
            /** Cues Accepted */
            cues_accepted: number;
            /**
             * Cues Wanted
             * @description Cues of the list that are not cut.
             */
            cues_wanted: number;
            /** @description That of the target's newest sealed pack. */
            handoff: components["schemas"]["Handoff"];
            changes: components["schemas"]["PackChanges"];
            /** Missing */
            missing: components["schemas"]["MissingFile"][];
        };
        /**
         * PackState
         * @description Whether a pack can be handed out.
         * @enum {string}
         */
        PackState: "sealing" | "sealed" | "refused";
        /** Page[BatchSummary] */
        Page_BatchSummary_: {
            /** Items */
            items: components["schemas"]["BatchSummary"][];
            /** Next */
            next?: string | null;
        };
        /** Page[BriefVersionSummary] */
        Page_BriefVersionSummary_: {
            /** Items */
            items: components["schemas"]["BriefVersionSummary"][];
            /** Next */
            next?: string | null;
        };
        /** Page[BuildSummary] */
        Page_BuildSummary_: {
            /** Items */
            items: components["schemas"]["BuildSummary"][];
            /** Next */
            next?: string | null;
        };
        /** Page[CameBack] */
        Page_CameBack_: {
            /** Items */
            items: components["schemas"]["CameBack"][];
            /** Next */
            next?: string | null;
        };
        /** Page[ChangeRequestRead] */
        Page_ChangeRequestRead_: {
            /** Items */
            items: components["schemas"]["ChangeRequestRead"][];
            /** Next */
            next?: string | null;
        };
        /** Page[DeliveryRead] */
        Page_DeliveryRead_: {
            /** Items */
            items: components["schemas"]["DeliveryRead"][];
            /** Next */
            next?: string | null;
        };
        /** Page[JobRead] */
        Page_JobRead_: {
            /** Items */
            items: components["schemas"]["JobRead"][];
            /** Next */
            next?: string | null;
        };
        /** Page[ProjectRead] */
        Page_ProjectRead_: {
            /** Items */
            items: components["schemas"]["ProjectRead"][];
            /** Next */
            next?: string | null;
        };
        /** Page[QuestionRead] */
        Page_QuestionRead_: {
            /** Items */
            items: components["schemas"]["QuestionRead"][];
            /** Next */
            next?: string | null;
        };
        /** Page[QueueItem] */
        Page_QueueItem_: {
            /** Items */
            items: components["schemas"]["QueueItem"][];
            /** Next */
            next?: string | null;
        };
        /** Page[RevisionRead] */
        Page_RevisionRead_: {
            /** Items */
            items: components["schemas"]["RevisionRead"][];
            /** Next */
            next?: string | null;
        };
        /** Page[SealedPackSummary] */
        Page_SealedPackSummary_: {
            /** Items */
            items: components["schemas"]["SealedPackSummary"][];
            /** Next */
            next?: string | null;
        };
        /** Page[SpecBrief] */
        Page_SpecBrief_: {
            /** Items */
            items: components["schemas"]["SpecBrief"][];
            /** Next */
            next?: string | null;
        };
        /** Page[TakeRead] */
        Page_TakeRead_: {
            /** Items */
            items: components["schemas"]["TakeRead"][];
            /** Next */
            next?: string | null;
        };
        /** Page[ToMake] */
        Page_ToMake_: {
            /** Items */
            items: components["schemas"]["ToMake"][];
            /** Next */
            next?: string | null;
        };
        /** Page[WithApprover] */
        Page_WithApprover_: {
            /** Items */
            items: components["schemas"]["WithApprover"][];
            /** Next */
            next?: string | null;
        };
        /**
         * PaletteSet
         * @description Whether the cue belongs to the palette that new sounds are compared with.
         */
        PaletteSet: {
            /** Palette */
            palette: boolean;
        };
        /**
         * PaletteSound
         * @description One sound of the palette.
         */
        PaletteSound: {
            cue: components["schemas"]["CueBrief"];
            /** Loop */
            loop: boolean;
            /** Thumb */
            thumb: {
                [key: string]: unknown;
            } | null;
            /** Preview Url */
            preview_url: string | null;
            /** Loudness Lufs */
            loudness_lufs: number | null;
        };
        /**
         * PartAsk
         * @description A part that is to be sent next.
         */
        PartAsk: {
            /**
             * Number
             * @description Parts count from 1.
             */
            number: number;
            /**
             * Sha256
             * @description Of the part's bytes, in hex; the store holds it to them.
             */
            sha256: string;
        };
        /**
         * PartLinkRead
         * @description The target of one part of a file: a PUT of exactly these bytes with exactly these headers.
         */
        PartLinkRead: {
            /** Number */
            number: number;
            /**
             * Start
             * @description The part's first byte in the file.
             */
            start: number;
            /** Length */
            length: number;
            /** Url */
            url: string;
            /** Headers */
            headers: {
                [key: string]: string;
            };
        };
        /**
         * PartsAsk
         * @description The parts of a file to send next.
         */
        PartsAsk: {
            /**
             * Parts
             * @default []
             */
            parts: components["schemas"]["PartAsk"][];
        };
        /**
         * PartsRead
         * @description The parts of a file, those in the store, and the targets of the requested ones.
         */
        PartsRead: {
            /**
             * Part Bytes
             * @description How long every part but the last is.
             */
            part_bytes: number;
            /** Parts */
            parts: number;
            /**
             * Here
             * @description Parts that are in the store.
             */
            here: number[];
            /** Links */
            links: components["schemas"]["PartLinkRead"][];
            /**
             * Links Expire At
             * Format: date-time
             */
            links_expire_at: string;
        };
        /**
         * Party
         * @description Who agrees with whom.
         * @enum {string}
         */
        Party: "studio" | "designer";
        /**
         * PasswordChange
         * @description The password that is and the one to be.
         */
        PasswordChange: {
            /** Current */
            current: string;
            /** New */
            new: string;
        };
        /**
         * PaymentAdd
         * @description Money that changed hands; below zero on a credit note.
         */
        PaymentAdd: {
            /** Amount Minor */
            amount_minor: number;
            /** Reference */
            reference: string;
            /**
             * Paid On
             * Format: date
             */
            paid_on: string;
        };
        /**
         * PaymentRead
         * @description A payment or, below zero, a refund.
         */
        PaymentRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Amount Minor */
            amount_minor: number;
            /** Reference */
            reference: string;
            /**
             * Paid On
             * Format: date
             */
            paid_on: string;
            /** Refund Of Id */
            refund_of_id: string | null;
            /** Left Minor */
            left_minor: number;
        };
        /**
         * PeaksRead
         * @description The shape of a sound across a screen.
         */
        PeaksRead: {
            /** Points */
            points: number;
            /** Frames */
            frames: number;
            /** Sample Rate Hz */
            sample_rate_hz: number;
            /** Duration S */
            duration_s: number;
            /**
             * Full Scale
             * @description The value of full scale; sounds drawn by an earlier version have 1.
             * @default 1
             */
            full_scale: number;
            /** Min */
            min: number[];
            /** Max */
            max: number[];
            /** Rms */
            rms: number[];
            /** @description Null for a sound that was drawn by an earlier version. */
            bands?: components["schemas"]["BandsRead"] | null;
        };
        /**
         * PerformerSource
         * @description A person who is heard in a sound.
         */
        PerformerSource: {
            /** Name */
            name: string;
            /**
             * Release
             * @description The signed release: its date, or where it is kept; empty: none yet.
             * @default
             */
            release: string;
        };
        /**
         * PersonBrief
         * @description A person's id and name.
         */
        PersonBrief: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Name */
            name: string;
        };
        /**
         * PersonRead
         * @description The caller's own account.
         */
        PersonRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Name */
            name: string;
            /** Email */
            email: string;
            /**
             * Email Verified At
             * @description Since when it is known that the account's holder reads this address.
             */
            email_verified_at: string | null;
        };
        /**
         * PersonScores
         * @description What one person of the team gave a bid.
         */
        PersonScores: {
            person: components["schemas"]["PersonBrief"];
            /** Scores */
            scores: {
                [key: string]: number;
            };
            /** Note */
            note: string;
        };
        /**
         * PlaceholderCountdown
         * @description The number of remaining placeholders, without their names.
         */
        PlaceholderCountdown: {
            /** Target */
            target: string;
            /**
             * Cues
             * @description Cues of the list that are not cut.
             */
            cues: number;
            /**
             * Cues Left
             * @description Those of which a file has no accepted sound.
             */
            cues_left: number;
            /** Files */
            files: number;
            /** Left */
            left: number;
            /**
             * Categories
             * @description By name; one without a category first.
             */
            categories: components["schemas"]["CategoryCountdown"][];
            /** @description The next to record: the most settled, in list order, of which no version is under way. */
            next: components["schemas"]["PlaceholderRead"] | null;
        };
        /**
         * PlaceholderRead
         * @description One file that the game has no accepted sound for yet.
         */
        PlaceholderRead: {
            /**
             * Cue Id
             * Format: uuid
             */
            cue_id: string;
            /** Cue */
            cue: string;
            /** Name */
            name: string;
            /** Variation */
            variation: number;
            /** Path */
            path: string;
            /** Category */
            category: string;
            /**
             * State
             * @description Whether a placeholder file is there; outdated: cue or spec changed since it was made.
             * @enum {string}
             */
            state: "missing" | "made" | "outdated" | "refused";
            /** Spoken */
            spoken: boolean;
            /** Refusal */
            refusal: string | null;
        };
        /**
         * PlaceholderRegister
         * @description The remaining placeholders, counted down as sounds are accepted.
         */
        PlaceholderRegister: {
            /** Target */
            target: string;
            /** Targets */
            targets: string[];
            /**
             * Files
             * @description Files that the list asks for.
             */
            files: number;
            /**
             * Replaced
             * @description Those with an accepted sound.
             */
            replaced: number;
            /** Left */
            left: number;
            /**
             * Made
             * @description Those left that have a placeholder file to spec.
             */
            made: number;
            /** Items */
            items: components["schemas"]["PlaceholderRead"][];
        };
        /**
         * PlaceholderSet
         * @description Whether the game plays a placeholder file for now.
         */
        PlaceholderSet: {
            /** Placeholder */
            placeholder: boolean;
        };
        /**
         * PlaceholdersAdd
         * @description For which target placeholder files are to be made.
         */
        PlaceholdersAdd: {
            /** Target */
            target: string;
        };
        /**
         * PlanChecked
         * @description What is wrong with a plan that is not saved, and what is unwise about it.
         */
        PlanChecked: {
            /** Faults */
            faults: components["schemas"]["PlanFault"][];
            /** Advice */
            advice: components["schemas"]["AdviceRead"][];
        };
        /**
         * PlanFault
         * @description What is wrong with a plan: `milestones.0` is its first one, `milestones` all of it.
         */
        PlanFault: {
            /** Where */
            where: string;
            /** Message */
            message: string;
        };
        /**
         * PlanProposal
         * @description Milestones over the cues that no agreed contract covers, in order.
         */
        PlanProposal: {
            /** Milestones */
            milestones: components["schemas"]["ProposedMilestoneRead"][];
        };
        /**
         * PlanRead
         * @description The milestones of a contract, and what is unwise about them.
         */
        PlanRead: {
            /**
             * Contract Id
             * Format: uuid
             */
            contract_id: string;
            state: components["schemas"]["ContractState"];
            /** Currency */
            currency: string;
            /** Milestones */
            milestones: components["schemas"]["MilestoneRead"][];
            /** Advice */
            advice: components["schemas"]["AdviceRead"][];
        };
        /**
         * PlanSet
         * @description The whole plan of a draft.
         */
        PlanSet: {
            /** Milestones */
            milestones: components["schemas"]["MilestoneSet"][];
        };
        /**
         * PlannedCueSet
         * @description A cue of a planned milestone; prices, where given, are the weights of its shares.
         */
        PlannedCueSet: {
            /**
             * Cue Id
             * Format: uuid
             */
            cue_id: string;
            /** Price Minor */
            price_minor?: number | null;
            /** Estimate Min */
            estimate_min?: number | null;
        };
        /**
         * PostingAdd
         * @description A posting to write.
         */
        PostingAdd: {
            /** Title */
            title: string;
            /**
             * Text
             * @default
             */
            text: string;
            /** @default production */
            phase: components["schemas"]["PostingPhase"];
            /**
             * Currency
             * @default USD
             */
            currency: string;
            /**
             * Price Minor
             * @description Of an advisory phase: what the studio pays for it.
             */
            price_minor?: number | null;
            /** Budget Minor */
            budget_minor?: number | null;
            /**
             * Is Budget Shown
             * @description Whether candidates see the budget.
             * @default false
             */
            is_budget_shown: boolean;
            /**
             * Rate Floor Minor
             * @description An effective hourly rate below it is pointed out to the team.
             */
            rate_floor_minor?: number | null;
            /** @default all */
            scope: components["schemas"]["AskedScope"];
            /** Categories */
            categories?: string[];
            /** Cue Ids */
            cue_ids?: string[];
            /**
             * Headings
             * @description What the team scores, 1 to 5 each.
             */
            headings?: string[];
            /**
             * Bids Until On
             * @description The last day on which bids are taken.
             */
            bids_until_on?: string | null;
            /** Work From On */
            work_from_on?: string | null;
            /** Work To On */
            work_to_on?: string | null;
        };
        /**
         * PostingAwarded
         * @description The draft contract that an award opened.
         */
        PostingAwarded: {
            /**
             * Project Id
             * Format: uuid
             */
            project_id: string;
            /**
             * Contract Id
             * Format: uuid
             */
            contract_id: string;
        };
        /**
         * PostingChange
         * @description A posting as it should be.
         */
        PostingChange: {
            /** Title */
            title: string;
            /**
             * Text
             * @default
             */
            text: string;
            /** @default production */
            phase: components["schemas"]["PostingPhase"];
            /**
             * Currency
             * @default USD
             */
            currency: string;
            /**
             * Price Minor
             * @description Of an advisory phase: what the studio pays for it.
             */
            price_minor?: number | null;
            /** Budget Minor */
            budget_minor?: number | null;
            /**
             * Is Budget Shown
             * @description Whether candidates see the budget.
             * @default false
             */
            is_budget_shown: boolean;
            /**
             * Rate Floor Minor
             * @description An effective hourly rate below it is pointed out to the team.
             */
            rate_floor_minor?: number | null;
            /** @default all */
            scope: components["schemas"]["AskedScope"];
            /** Categories */
            categories?: string[];
            /** Cue Ids */
            cue_ids?: string[];
            /**
             * Headings
             * @description What the team scores, 1 to 5 each.
             */
            headings?: string[];
            /**
             * Bids Until On
             * @description The last day on which bids are taken.
             */
            bids_until_on?: string | null;
            /** Work From On */
            work_from_on?: string | null;
            /** Work To On */
            work_to_on?: string | null;
            /**
             * Revision
             * @description The revision that was read.
             */
            revision: number;
        };
        /**
         * PostingJoined
         * @description The posting that the caller may bid on from now on.
         */
        PostingJoined: {
            /**
             * Posting Id
             * Format: uuid
             */
            posting_id: string;
        };
        /**
         * PostingLink
         * @description The link of a posting; shown this once.
         */
        PostingLink: {
            /** Url */
            url: string;
        };
        /**
         * PostingPhase
         * @description What a posting is about: making sounds, or advice before that.
         * @enum {string}
         */
        PostingPhase: "production" | "advisory";
        /**
         * PostingPreview
         * @description The page of a posting's link, before any account.
         */
        PostingPreview: {
            /**
             * Email
             * @description Whose personal link it is; null for the link for everyone.
             */
            email: string | null;
            /**
             * Has Account
             * @description Whether this address has an account.
             */
            has_account: boolean;
            /** Studio Name */
            studio_name: string;
            /**
             * Project Name
             * @description Empty while an NDA comes first.
             */
            project_name: string;
            /** Title */
            title: string;
            state: components["schemas"]["PostingState"];
            /** Takes Bids */
            takes_bids: boolean;
            phase: components["schemas"]["PostingPhase"];
            /** Nda Needed */
            nda_needed: boolean;
            /** Bids Until On */
            bids_until_on: string | null;
            /** Work From On */
            work_from_on: string | null;
            /** Work To On */
            work_to_on: string | null;
            /** Text */
            text: string;
            /** Currency */
            currency: string;
            /** Price Minor */
            price_minor: number | null;
            /** Budget Minor */
            budget_minor: number | null;
            /** Lines */
            lines: components["schemas"]["AskedLine"][];
        };
        /**
         * PostingQuestionAdd
         * @description A question about a posting.
         */
        PostingQuestionAdd: {
            /** Text */
            text: string;
        };
        /**
         * PostingQuestionAnswer
         * @description The answer to a question, for all candidates or for the one who asked.
         */
        PostingQuestionAnswer: {
            /** Text */
            text: string;
            /** Is For All */
            is_for_all: boolean;
        };
        /**
         * PostingQuestionRead
         * @description What a candidate asks about a posting, and the answer.
         */
        PostingQuestionRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Text */
            text: string;
            /** @description Null where another candidate asked. */
            asked_by: components["schemas"]["PersonBrief"] | null;
            /**
             * Asked At
             * Format: date-time
             */
            asked_at: string;
            /** Answer */
            answer: string | null;
            /** Is For All */
            is_for_all: boolean;
            /** Answered At */
            answered_at: string | null;
        };
        /**
         * PostingRead
         * @description A posting as the caller may see it.
         */
        PostingRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /**
             * Project Id
             * Format: uuid
             */
            project_id: string;
            /** Project Name */
            project_name: string;
            /** Studio Name */
            studio_name: string;
            /** Title */
            title: string;
            state: components["schemas"]["PostingState"];
            /** Takes Bids */
            takes_bids: boolean;
            /** Bids Until On */
            bids_until_on: string | null;
            /** Work From On */
            work_from_on: string | null;
            /** Work To On */
            work_to_on: string | null;
            phase: components["schemas"]["PostingPhase"];
            /** Revision */
            revision: number;
            /** Currency */
            currency: string;
            /**
             * Nda Open
             * @description An NDA comes first: until it is signed only title, dates and studio are shown.
             */
            nda_open: boolean;
            /** Is Team */
            is_team: boolean;
            /** Text */
            text: string;
            /** Price Minor */
            price_minor: number | null;
            /**
             * Budget Minor
             * @description Null where it is not shown to the caller, or not named.
             */
            budget_minor: number | null;
            /** Is Budget Shown */
            is_budget_shown: boolean;
            /**
             * Rate Floor Minor
             * @description For the team only.
             */
            rate_floor_minor: number | null;
            scope: components["schemas"]["AskedScope"];
            /** Categories */
            categories: string[];
            /**
             * Cue Ids
             * @description For the team only.
             */
            cue_ids: string[];
            /** Lines */
            lines: components["schemas"]["AskedLine"][];
            /**
             * Headings
             * @description For the team only.
             */
            headings: string[];
            /**
             * Has Link
             * @description For the team: whether a link without an invitation is open.
             */
            has_link: boolean;
            /**
             * Candidates
             * @description For the team only.
             */
            candidates: components["schemas"]["CandidateRead"][];
            /** Questions */
            questions: components["schemas"]["PostingQuestionRead"][];
            /**
             * Bids
             * @description For the team: how many were sent.
             */
            bids: number | null;
            own_bid: components["schemas"]["OwnBidRead"] | null;
            /**
             * Clashes
             * @description For the candidate: offers and awards elsewhere in these days.
             */
            clashes: components["schemas"]["Clash"][];
            /** Opened At */
            opened_at: string | null;
            /** Closed At */
            closed_at: string | null;
            /** Awarded At */
            awarded_at: string | null;
            /**
             * Contract Id
             * @description For the team: the draft that the award opened.
             */
            contract_id: string | null;
        };
        /**
         * PostingState
         * @description Where a posting is between writing and award.
         * @enum {string}
         */
        PostingState: "draft" | "open" | "closed" | "awarded";
        /**
         * PostingSummary
         * @description A posting in a list.
         */
        PostingSummary: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /**
             * Project Id
             * Format: uuid
             */
            project_id: string;
            /** Project Name */
            project_name: string;
            /** Studio Name */
            studio_name: string;
            /** Title */
            title: string;
            phase: components["schemas"]["PostingPhase"];
            state: components["schemas"]["PostingState"];
            /** Takes Bids */
            takes_bids: boolean;
            /** Bids Until On */
            bids_until_on: string | null;
            /** Work From On */
            work_from_on: string | null;
            /** Work To On */
            work_to_on: string | null;
            /**
             * Bids
             * @description How many were sent; null for candidates.
             */
            bids: number | null;
            own_bid: components["schemas"]["BidState"] | null;
        };
        /**
         * PresetRead
         * @description A target for one engine, to be added to the spec.
         */
        PresetRead: {
            /** Name */
            name: string;
            /** Engine */
            engine: string;
            /** Accepts */
            accepts: string;
            /** Why */
            why: string;
            /** Toml */
            toml: string;
        };
        /**
         * PreviewCue
         * @description A cue as an invited designer sees it before having an account.
         */
        PreviewCue: {
            /** Number */
            number: number;
            /** Label */
            label: string;
            /** Name */
            name: string;
            /** File Name */
            file_name: string;
            /** Category */
            category: string;
            /** Description */
            description: string;
            /** Use */
            use: string;
            /** Duration S */
            duration_s: number | null;
            /** Loop */
            loop: boolean;
            /** Variations */
            variations: number;
            state: components["schemas"]["CueState"];
        };
        /**
         * PreviewProject
         * @description The project that an invitation is for.
         */
        PreviewProject: {
            /** Name */
            name: string;
            /** Description */
            description: string;
            /** Cue Prefix */
            cue_prefix: string;
        };
        /**
         * Problem
         * @description Problem details (RFC 9457); `code` never changes for one condition.
         */
        Problem: {
            /**
             * Type
             * @default about:blank
             */
            type: string;
            /** Title */
            title: string;
            /** Status */
            status: number;
            /** Code */
            code: string;
            /** Detail */
            detail: string;
            /** Fix */
            fix?: string | null;
            /**
             * Errors
             * @default []
             */
            errors: components["schemas"]["FieldProblem"][];
            /** Request Id */
            request_id?: string | null;
        };
        /**
         * ProjectAdd
         * @description A new project.
         */
        ProjectAdd: {
            /**
             * Studio Id
             * Format: uuid
             */
            studio_id: string;
            /** Name */
            name: string;
            /**
             * Description
             * @default
             */
            description: string;
            /**
             * Cue Prefix
             * @description One to eight capitals and digits: SW numbers the cues SW-001, SW-002 …
             */
            cue_prefix: string;
            /**
             * Preset
             * @default 44k1
             * @enum {string}
             */
            preset: "44k1" | "48k";
        };
        /**
         * ProjectChange
         * @description Changes; omitted fields stay.
         */
        ProjectChange: {
            /** Name */
            name?: string | null;
            /** Description */
            description?: string | null;
            /** Cue Prefix */
            cue_prefix?: string | null;
            /** Archived */
            archived?: boolean | null;
            /** Nda Needed */
            nda_needed?: boolean | null;
        };
        /**
         * ProjectMoney
         * @description The money of a project, as far as the caller sees its contracts.
         */
        ProjectMoney: {
            /** Contracts */
            contracts: components["schemas"]["ContractMoney"][];
            /** Totals */
            totals: components["schemas"]["CurrencyFigures"][];
        };
        /**
         * ProjectRead
         * @description A project as its page's header shows it; a designer sees only their own engagement.
         */
        ProjectRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Name */
            name: string;
            /** Description */
            description: string;
            /** Cue Prefix */
            cue_prefix: string;
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            /** Archived At */
            archived_at: string | null;
            /**
             * Nda Needed
             * @description Designers see brief, list and spec once they accepted an NDA.
             */
            nda_needed: boolean;
            studio: components["schemas"]["StudioBrief"];
            approver: components["schemas"]["PersonBrief"];
            /**
             * Category Approvers
             * @description All other categories are the approver's.
             */
            category_approvers: components["schemas"]["CategoryApproverRead"][];
            /** Liaisons */
            liaisons: components["schemas"]["PersonBrief"][];
            /** Engagements */
            engagements: components["schemas"]["EngagementRead"][];
            mine: components["schemas"]["Mine"];
            /** Spec Version */
            spec_version: number;
        };
        /**
         * ProposedMilestoneRead
         * @description A milestone to begin from.
         */
        ProposedMilestoneRead: {
            /** Name */
            name: string;
            /** Due On */
            due_on: string | null;
            /** Is Deposit */
            is_deposit: boolean;
            /** Amount Minor */
            amount_minor: number | null;
            /** Cue Ids */
            cue_ids: string[];
        };
        /**
         * QuestionAdd
         * @description A question that a designer needs answered to make the sound.
         */
        QuestionAdd: {
            /** Text */
            text: string;
        };
        /**
         * QuestionRead
         * @description A question on a cue, and its answer.
         */
        QuestionRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /**
             * Cue Id
             * Format: uuid
             */
            cue_id: string;
            /** Cue Label */
            cue_label: string;
            /** Cue Name */
            cue_name: string;
            /** Text */
            text: string;
            /** @description Null where a designer looks at another designer's question. */
            asked_by: components["schemas"]["PersonBrief"] | null;
            /**
             * Asked At
             * Format: date-time
             */
            asked_at: string;
            /** Answer */
            answer: string | null;
            answered_by: components["schemas"]["PersonBrief"] | null;
            /** Answered At */
            answered_at: string | null;
        };
        /**
         * QueueCount
         * @description The number of cues that wait for the approver, counted up to a limit.
         */
        QueueCount: {
            /** Cues */
            cues: number;
            /**
             * Is All
             * @description Whether no more wait than are counted here.
             */
            is_all: boolean;
        };
        /**
         * QueueItem
         * @description One cue that waits for the approver, with every take of it that waits.
         */
        QueueItem: {
            cue: components["schemas"]["ReviewCue"];
            kind: components["schemas"]["QueueKind"];
            /**
             * Waiting Since
             * Format: date-time
             */
            waiting_since: string;
            /** Rounds So Far */
            rounds_so_far: number;
            /**
             * Last Change
             * @description What was asked last of this cue, which these takes answer.
             */
            last_change: string | null;
            /**
             * Open Notes
             * @description Notes on earlier versions that are not done in these.
             */
            open_notes: number;
            /** Approved Variations */
            approved_variations: number[];
            /**
             * Accepted After
             * @description Day after which the cue counts as accepted without a verdict, by its contract's clause on silence.
             */
            accepted_after: string | null;
            /**
             * Silence Paused By
             * @description What is open, so that the days of the clause do not count.
             */
            silence_paused_by: ("question" | "change_order") | null;
            /** Findings Count */
            findings_count: number;
            worst_finding: components["schemas"]["FindingRead"] | null;
            /** Takes */
            takes: components["schemas"]["ReviewTake"][];
        };
        /**
         * QueueKind
         * @description How the waiting takes of a cue are played.
         * @enum {string}
         */
        QueueKind: "single" | "alternates" | "set";
        /**
         * QuotaKind
         * @description The limited resources.
         * @enum {string}
         */
        QuotaKind: "master_bytes" | "cues" | "projects" | "people" | "tokens" | "open_uploads";
        /**
         * QuotaRead
         * @description One limit of a studio, and what it has of that.
         */
        QuotaRead: {
            kind: components["schemas"]["QuotaKind"];
            /** Used */
            used: number;
            /** Limit */
            limit: number;
            /** Default */
            default: number;
        };
        /**
         * RangeRead
         * @description A lower and an upper bound; null does not limit.
         */
        RangeRead: {
            /** Min */
            min: number | null;
            /** Max */
            max: number | null;
        };
        /**
         * ReasonGiven
         * @description Why a change order is refused or withdrawn.
         */
        ReasonGiven: {
            /** Reason */
            reason: string;
        };
        /**
         * RecallAdd
         * @description Why a text is taken back.
         */
        RecallAdd: {
            /** Reason */
            reason: string;
        };
        /**
         * RecentVerdict
         * @description A cue of which a take was approved, or a change requested, within a week.
         */
        RecentVerdict: {
            cue: components["schemas"]["CueBrief"];
            /**
             * Status
             * @enum {string}
             */
            status: "accepted" | "change_requested";
            /**
             * Since
             * Format: date-time
             */
            since: string;
        };
        /**
         * RecordEntryRead
         * @description One entry of the record.
         */
        RecordEntryRead: {
            /** Seq */
            seq: number;
            /** At */
            at: string;
            /** Kind */
            kind: string;
            /** Payload */
            payload: {
                [key: string]: unknown;
            };
            /** Previous Sha256 */
            previous_sha256: string;
            /** Sha256 */
            sha256: string;
        };
        /**
         * RecordRead
         * @description The record of a contract, and whether it is the one that was written.
         */
        RecordRead: {
            /**
             * Contract Id
             * Format: uuid
             */
            contract_id: string;
            /** Title */
            title: string;
            /** Length */
            length: number;
            /** Sha256 */
            sha256: string;
            /** Faults */
            faults: string[];
            /** Entries */
            entries: components["schemas"]["RecordEntryRead"][];
        };
        /**
         * RedlineAdd
         * @description A change of one clause; what is struck needs neither title nor text.
         */
        RedlineAdd: {
            /**
             * Title
             * @default
             */
            title: string;
            /**
             * Text
             * @default
             */
            text: string;
            /**
             * Terms
             * @description Values that change, by name.
             * @default {}
             */
            terms: {
                [key: string]: number | string;
            };
            kind: components["schemas"]["RedlineKind"];
            /**
             * Clause Key
             * @description The clause that is replaced or struck.
             */
            clause_key?: string | null;
            /**
             * After Key
             * @description Of an inserted clause, the one before it; null: it is the first.
             */
            after_key?: string | null;
            /**
             * Comment
             * @default
             */
            comment: string;
        };
        /**
         * RedlineAnswerAdd
         * @description The studio's answer; a counter has its own wording, a refusal a comment.
         */
        RedlineAnswerAdd: {
            /**
             * Title
             * @default
             */
            title: string;
            /**
             * Text
             * @default
             */
            text: string;
            /**
             * Terms
             * @description Values that change, by name.
             * @default {}
             */
            terms: {
                [key: string]: number | string;
            };
            answer: components["schemas"]["AnswerKind-Input"];
            /**
             * Comment
             * @default
             */
            comment: string;
        };
        /**
         * RedlineAnswerRead
         * @description What the studio said, and its own wording if it countered.
         */
        RedlineAnswerRead: {
            kind: components["schemas"]["app__agreements__redline_rules__AnswerKind"];
            wording: components["schemas"]["WordingRead"] | null;
            /** Comment */
            comment: string;
            /** By */
            by: string;
            /**
             * At
             * Format: date-time
             */
            at: string;
        };
        /**
         * RedlineKind
         * @description What is proposed of a clause.
         * @enum {string}
         */
        RedlineKind: "replace" | "strike" | "insert";
        /**
         * RedlineRead
         * @description A change of one clause that was proposed, and the studio's last answer.
         */
        RedlineRead: {
            /** Number */
            number: number;
            kind: components["schemas"]["RedlineKind"];
            /** Clause Key */
            clause_key: string;
            wording: components["schemas"]["WordingRead"];
            /** Comment */
            comment: string;
            answer: components["schemas"]["RedlineAnswerRead"] | null;
        };
        /**
         * RedlineRoundRead
         * @description Redlines that were proposed together.
         */
        RedlineRoundRead: {
            /** Number */
            number: number;
            /**
             * Version
             * @description The version that they are about.
             */
            version: number;
            /**
             * Sent Version
             * @description The version that was sent with the answers; null: none yet.
             */
            sent_version: number | null;
            /** Note */
            note: string;
            /** By */
            by: string;
            /**
             * At
             * Format: date-time
             */
            at: string;
            /** Unanswered */
            unanswered: number;
            /** Clauses */
            clauses: components["schemas"]["MarkedClauseRead"][];
        };
        /**
         * RedlinesAdd
         * @description Changes of the version that was sent.
         */
        RedlinesAdd: {
            /** Version */
            version: number;
            /** Changes */
            changes: components["schemas"]["RedlineAdd"][];
            /**
             * Note
             * @default
             */
            note: string;
        };
        /**
         * RedlinesPreview
         * @description The text as changes would mark it, and what is wrong with them: `changes.INDEX`.
         */
        RedlinesPreview: {
            /** Clauses */
            clauses: components["schemas"]["MarkedClauseRead"][];
            /** Problems */
            problems: components["schemas"]["DraftProblem"][];
        };
        /**
         * RedlinesRead
         * @description One round of redlines in the text that it is about, and how many rounds there are.
         */
        RedlinesRead: {
            /**
             * Contract Id
             * Format: uuid
             */
            contract_id: string;
            /**
             * Project Id
             * Format: uuid
             */
            project_id: string;
            /** Rounds */
            rounds: number;
            /** @description Null where nothing was ever proposed. */
            round: components["schemas"]["RedlineRoundRead"] | null;
            /** May Answer */
            may_answer: boolean;
        };
        /**
         * RedlinesSet
         * @description Changes of a text, to see what they would do.
         */
        RedlinesSet: {
            /** Changes */
            changes: components["schemas"]["RedlineAdd"][];
        };
        /**
         * ReelAdd
         * @description The order and gaps of a cue's takes in a reel.
         */
        ReelAdd: {
            /**
             * Gap Ms
             * @description Silence between takes.
             * @default 500
             */
            gap_ms: number;
            /**
             * Crossfade Ms
             * @description In place of the gap; 0: none.
             * @default 0
             */
            crossfade_ms: number;
            /**
             * Slates
             * @description How each take is announced; by beeps too if the server has no speech.
             * @default spoken
             * @enum {string}
             */
            slates: "spoken" | "beeped" | "none";
            /**
             * Order
             * @description Which take comes first, of each variation.
             * @default oldest
             * @enum {string}
             */
            order: "oldest" | "newest";
        };
        /**
         * ReelRead
         * @description All takes of a cue in a row, to be listened to; never for what ships.
         */
        ReelRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /**
             * Cue Id
             * Format: uuid
             */
            cue_id: string;
            /**
             * State
             * @enum {string}
             */
            state: "making" | "made" | "refused";
            /** Refusal */
            refusal: string | null;
            /** Gap Ms */
            gap_ms: number;
            /** Crossfade Ms */
            crossfade_ms: number;
            /**
             * Slates
             * @enum {string}
             */
            slates: "spoken" | "beeped" | "none";
            /** Takes */
            takes: components["schemas"]["ReelTake"][];
            /** Duration S */
            duration_s: number | null;
            /** File Bytes */
            file_bytes: number | null;
            /** File Name */
            file_name: string;
            /** File Url */
            file_url: string | null;
        };
        /**
         * ReelTake
         * @description One take of a reel.
         */
        ReelTake: {
            /**
             * Take Id
             * Format: uuid
             */
            take_id: string;
            /** Variation */
            variation: number;
            /** Number */
            number: number;
            /**
             * Start S
             * @description Where it begins; null until the reel is made.
             */
            start_s: number | null;
        };
        /**
         * ReleaseClause
         * @description When an accepted cue's share becomes due.
         * @enum {string}
         */
        ReleaseClause: "per_cue" | "on_completion";
        /**
         * RenderSoundRead
         * @description One game file of a take at the current spec, or the reason why there is none.
         */
        RenderSoundRead: {
            /** Picture Id */
            picture_id: string | null;
            /** Duration S */
            duration_s: number | null;
            thumb: components["schemas"]["ThumbRead"] | null;
            /** Preview Url */
            preview_url: string | null;
            /** Peaks Url */
            peaks_url: string | null;
            /** Spectrum Url */
            spectrum_url: string | null;
            /** Id */
            id: string | null;
            /** Target */
            target: string;
            /** State */
            state: components["schemas"]["RenderState"] | "waiting";
            /** Refusal */
            refusal: string | null;
            /** Facts */
            facts: {
                [key: string]: unknown;
            };
            /** Measurements */
            measurements: {
                [key: string]: unknown;
            };
            /** Attenuation Db */
            attenuation_db: number | null;
            /** File Bytes */
            file_bytes: number | null;
            /** File Url */
            file_url: string | null;
        };
        /**
         * RenderState
         * @description Whether the game file exists.
         * @enum {string}
         */
        RenderState: "made" | "refused";
        /**
         * RepairRead
         * @description One thing that a fix put right.
         */
        RepairRead: {
            /**
             * Kind
             * @enum {string}
             */
            kind: "gain" | "head" | "tail" | "name" | "header" | "depth" | "offset";
            /**
             * Codes
             * @description The findings that it answers.
             */
            codes: string[];
            /**
             * Words
             * @example level lowered by 1.70 dB
             */
            words: string;
            /**
             * Start S
             * @description Where in the take: what was cut, or the spot of the level.
             */
            start_s: number | null;
            /** End S */
            end_s: number | null;
        };
        /**
         * ReportFile
         * @description The report on one file.
         */
        ReportFile: {
            /** Path */
            path: string;
            /**
             * Verdict
             * @enum {string}
             */
            verdict: "conforming" | "rejected" | "unreadable" | "unjudged";
            /** Findings */
            findings: components["schemas"]["ReportFinding"][];
        } & {
            [key: string]: unknown;
        };
        /**
         * ReportFinding
         * @description One rule that a file breaks.
         */
        ReportFinding: {
            /** Code */
            code: string;
            /**
             * Severity
             * @enum {string}
             */
            severity: "error" | "warning";
            /** Message */
            message: string;
            /**
             * Waived
             * @default false
             */
            waived: boolean;
        } & {
            [key: string]: unknown;
        };
        /**
         * ReportSpec
         * @description The spec that the files were judged by.
         */
        ReportSpec: {
            /** Name */
            name: string;
            /** Sha256 */
            sha256: string;
        } & {
            [key: string]: unknown;
        };
        /**
         * ReportTool
         * @description The tool that wrote the report.
         */
        ReportTool: {
            /** Name */
            name: string;
            /** Version */
            version: string;
        } & {
            [key: string]: unknown;
        };
        /**
         * RepriceCue
         * @description Another price of a cue.
         */
        RepriceCue: {
            /**
             * @description discriminator enum property added by openapi-typescript
             * @enum {string}
             */
            kind: "reprice_cue";
            /**
             * Cue Id
             * Format: uuid
             */
            cue_id: string;
            /** Price Minor */
            price_minor: number;
        };
        /**
         * ResetAdd
         * @description Whose password was forgotten.
         */
        ResetAdd: {
            /** Email */
            email: string;
        };
        /**
         * ResolvedSpec
         * @description The spec with its defaults filled in, for sounds of no category.
         */
        ResolvedSpec: {
            /** Name */
            name: string;
            accept: components["schemas"]["AcceptRead"];
            limits: components["schemas"]["LimitsRead"];
            naming: components["schemas"]["NamingRead"];
            /** Required Metadata */
            required_metadata: string[];
            engine: components["schemas"]["EngineRead"];
            /** Targets */
            targets: {
                [key: string]: components["schemas"]["TargetRead"];
            };
            /** Checks */
            checks: {
                [key: string]: string;
            };
            /** Categories */
            categories: string[];
        };
        /**
         * Reverb
         * @description Whether the file contains reverb.
         * @enum {string}
         */
        Reverb: "dry" | "designed-tail" | "separate-tail";
        /**
         * ReviewCue
         * @description The cue that waiting takes are for.
         */
        ReviewCue: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /**
             * Project Id
             * Format: uuid
             */
            project_id: string;
            /**
             * Label
             * @example SW-007
             */
            label: string;
            /** Name */
            name: string;
            /** Description */
            description: string;
            /** Use */
            use: string;
            /** Category */
            category: string;
            /** Duration S */
            duration_s: number | null;
            /** Loop */
            loop: boolean;
            /** Variations */
            variations: number;
            state: components["schemas"]["CueState"];
            reverb: components["schemas"]["Reverb"] | null;
            /** Placeholder */
            placeholder: boolean;
            /** Palette */
            palette: boolean;
        };
        /**
         * ReviewRender
         * @description One game file of a take, or why there is none.
         */
        ReviewRender: {
            /** Picture Id */
            picture_id: string | null;
            /** Duration S */
            duration_s: number | null;
            thumb: components["schemas"]["ThumbRead"] | null;
            /** Preview Url */
            preview_url: string | null;
            /** Peaks Url */
            peaks_url: string | null;
            /** Spectrum Url */
            spectrum_url: string | null;
            /** Id */
            id: string | null;
            /** Target */
            target: string;
            /** State */
            state: components["schemas"]["RenderState"] | "waiting";
            /** Refusal */
            refusal: string | null;
            /** Attenuation Db */
            attenuation_db: number | null;
            /**
             * Loudness Lufs
             * @description Measured of the file, as the take's own is.
             */
            loudness_lufs: number | null;
            /** True Peak Dbtp */
            true_peak_dbtp: number | null;
        };
        /**
         * ReviewTake
         * @description One take, with what is needed to play and judge it.
         */
        ReviewTake: {
            /** Picture Id */
            picture_id: string | null;
            /** Duration S */
            duration_s: number | null;
            thumb: components["schemas"]["ThumbRead"] | null;
            /** Preview Url */
            preview_url: string | null;
            /** Peaks Url */
            peaks_url: string | null;
            /** Spectrum Url */
            spectrum_url: string | null;
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Variation */
            variation: number;
            /** Number */
            number: number;
            /** Alternate */
            alternate: number | null;
            /** File Name */
            file_name: string;
            state: components["schemas"]["TakeState"];
            /**
             * State Since
             * Format: date-time
             */
            state_since: string;
            /**
             * Received At
             * Format: date-time
             */
            received_at: string;
            /** Late */
            late: boolean;
            /** Note */
            note: string;
            /** Delivery Number */
            delivery_number: number;
            /** Delivery Note */
            delivery_note: string;
            designer: components["schemas"]["PersonBrief"];
            /** Facts */
            facts: {
                [key: string]: unknown;
            };
            /**
             * Loudness Lufs
             * @description Integrated, or of the loudest 0.4 s where that is all there is.
             */
            loudness_lufs: number | null;
            /**
             * Away From Set Lu
             * @description Louder than the middle of the other variations by so much.
             */
            away_from_set_lu: number | null;
            /** Sample Peak Dbfs */
            sample_peak_dbfs: number | null;
            /** True Peak Dbtp */
            true_peak_dbtp: number | null;
            /** Measurements */
            measurements: {
                [key: string]: unknown;
            };
            /** Findings */
            findings: components["schemas"]["FindingRead"][];
            /** Waived */
            waived: boolean;
            /** Waiver Reason */
            waiver_reason: string | null;
            /**
             * Fix Of Id
             * @description The version that this one is a fix of.
             */
            fix_of_id: string | null;
            /** Renders */
            renders: components["schemas"]["ReviewRender"][];
            draft_change: components["schemas"]["ChangeRequestRead"] | null;
            /** Open Comments */
            open_comments: number;
        };
        /**
         * RevisionRead
         * @description One saved change of the list.
         */
        RevisionRead: {
            /** Number */
            number: number;
            /** Summary */
            summary: string;
            author: components["schemas"]["PersonBrief"];
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
        };
        /**
         * Role
         * @description A member's role in the studio; liaisons and the approver are named per project.
         * @enum {string}
         */
        Role: "producer" | "liaison" | "reviewer" | "implementer";
        /**
         * RolesChange
         * @description A member's new role.
         */
        RolesChange: {
            /** Roles */
            roles: components["schemas"]["Role"][];
        };
        /**
         * RoundRead
         * @description One sending, counted once for a cue or set; `number` is null where it is not counted, with the reason.
         */
        RoundRead: {
            /**
             * Cue Id
             * Format: uuid
             */
            cue_id: string;
            /** Number */
            number: number | null;
            /** Why Not Counted */
            why_not_counted: string | null;
            /**
             * Feedback Id
             * Format: uuid
             */
            feedback_id: string;
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
        };
        /**
         * RunRead
         * @description Words in both texts, in the earlier alone, or in the later alone.
         */
        RunRead: {
            /**
             * Is In
             * @enum {string}
             */
            is_in: "both" | "earlier" | "later";
            /** Text */
            text: string;
        };
        /**
         * Scope
         * @description The rights of a build's token.
         * @enum {string}
         */
        Scope: "spec:read" | "list:read" | "checks:write" | "manifest:read" | "deliveries:write" | "rights:read";
        /**
         * ScoresWrite
         * @description What the caller gives a bid under each heading.
         */
        ScoresWrite: {
            /** Scores */
            scores: {
                [key: string]: number;
            };
            /**
             * Note
             * @default
             */
            note: string;
        };
        /**
         * SealedPackRead
         * @description A pack, and what is not as it was in the one before.
         */
        SealedPackRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Target */
            target: string;
            /** Number */
            number: number;
            /** Note */
            note: string;
            /** With Masters */
            with_masters: boolean;
            /** Placeholders */
            placeholders: boolean;
            handoff: components["schemas"]["Handoff"];
            state: components["schemas"]["PackState"];
            /**
             * Refusal
             * @description Why it could not be put together.
             */
            refusal: string;
            /** Sealed By */
            sealed_by: string;
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            /** Sealed At */
            sealed_at: string | null;
            /**
             * Files
             * @description Game files.
             */
            files: number;
            /**
             * Placeholder Files
             * @description Placeholder files in addition.
             */
            placeholder_files: number;
            /** Bytes */
            bytes: number;
            changes: components["schemas"]["PackChanges"];
        };
        /**
         * SealedPackSummary
         * @description A pack that was handed out, or is being put together.
         */
        SealedPackSummary: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Target */
            target: string;
            /** Number */
            number: number;
            /** Note */
            note: string;
            /** With Masters */
            with_masters: boolean;
            /** Placeholders */
            placeholders: boolean;
            handoff: components["schemas"]["Handoff"];
            state: components["schemas"]["PackState"];
            /**
             * Refusal
             * @description Why it could not be put together.
             */
            refusal: string;
            /** Sealed By */
            sealed_by: string;
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            /** Sealed At */
            sealed_at: string | null;
            /**
             * Files
             * @description Game files.
             */
            files: number;
            /**
             * Placeholder Files
             * @description Placeholder files in addition.
             */
            placeholder_files: number;
            /** Bytes */
            bytes: number;
        };
        /**
         * SeamRead
         * @description A loop's seam against the sound around it.
         */
        SeamRead: {
            /** Step Db */
            step_db: number | null;
            /** Slope Db */
            slope_db: number | null;
        };
        /**
         * SendAdd
         * @description What goes with the text.
         */
        SendAdd: {
            /**
             * Note
             * @default
             */
            note: string;
        };
        /**
         * ServerOperations
         * @description The whole server's jobs and workers.
         */
        ServerOperations: {
            /** Counts */
            counts: components["schemas"]["JobCountRead"][];
            /**
             * Lanes
             * @description The longest first, fifty at most.
             */
            lanes: components["schemas"]["LaneRead"][];
            /**
             * Workers
             * @description Those that said within the hour that they live.
             */
            workers: components["schemas"]["WorkerRead"][];
        };
        /**
         * ServerStorage
         * @description The storage of the whole server.
         */
        ServerStorage: {
            /**
             * Studios
             * @description The largest first.
             */
            studios: components["schemas"]["StorageRead"][];
            /**
             * Free Bytes
             * @description What the disk of the store has left; null where the store is a bucket.
             */
            free_bytes: number | null;
        };
        /**
         * SessionRead
         * @description Whether the caller is signed in, and whether this is the demo, which needs no sign-in.
         */
        SessionRead: {
            /** Signed In */
            signed_in: boolean;
            /** Demo */
            demo: boolean;
            person: components["schemas"]["PersonBrief"] | null;
        };
        /**
         * SetAccept
         * @description The acceptance of a whole set; where no take is named, the newest conforming one of a variation is meant.
         */
        SetAccept: {
            /**
             * Note
             * @default
             */
            note: string;
            /**
             * Take Ids
             * @default []
             */
            take_ids: string[];
        };
        /**
         * SetAccepted
         * @description The decisions made by accepting a set.
         */
        SetAccepted: {
            /**
             * Cue Id
             * Format: uuid
             */
            cue_id: string;
            /** Cue Accepted */
            cue_accepted: boolean;
            /** Approved */
            approved: components["schemas"]["TakeStateRead"][];
            /** Set Aside */
            set_aside: string[];
            /**
             * Undo Until
             * Format: date-time
             */
            undo_until: string;
        };
        /**
         * ShapeRead
         * @description The shape of a stretch of sound: ±1.0 is full scale.
         */
        ShapeRead: {
            /** Frames */
            frames: number;
            /** Sample Rate Hz */
            sample_rate_hz: number;
            /** Min */
            min: number[];
            /** Max */
            max: number[];
            /** Rms */
            rms: number[];
        };
        /**
         * Shipped
         * @description The day on which the game shipped.
         */
        Shipped: {
            /**
             * Shipped On
             * Format: date
             */
            shipped_on: string;
        };
        /**
         * ShortlistWrite
         * @description Whether a bid is on the shortlist.
         */
        ShortlistWrite: {
            /** Is Shortlisted */
            is_shortlisted: boolean;
        };
        /**
         * SignInAdd
         * @description Address and password.
         */
        SignInAdd: {
            /** Email */
            email: string;
            /** Password */
            password: string;
        };
        /**
         * SignInRead
         * @description One browser in which the caller is signed in.
         */
        SignInRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /**
             * Device
             * @description Browser and system, as the browser names them; empty if unknown.
             */
            device: string;
            /**
             * Place
             * @description Network address that it signed in from.
             */
            place: string;
            /** Is Current */
            is_current: boolean;
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            /**
             * Last Seen At
             * Format: date-time
             * @description To within ten minutes.
             */
            last_seen_at: string;
            /**
             * Expires At
             * Format: date-time
             */
            expires_at: string;
        };
        /**
         * SignUpAdd
         * @description A new account and its studio.
         */
        SignUpAdd: {
            /** Email */
            email: string;
            /** Name */
            name: string;
            /** Password */
            password: string;
            /** Studio Name */
            studio_name: string;
        };
        /**
         * SignUpFinish
         * @description The rest of a new account, and its studio.
         */
        SignUpFinish: {
            /** Name */
            name: string;
            /** Password */
            password: string;
            /** Studio Name */
            studio_name: string;
        };
        /**
         * SignUpMode
         * @description How a person can get an account here.
         */
        SignUpMode: {
            /**
             * Open
             * @description Whether anyone may sign up now; otherwise people are invited.
             */
            open: boolean;
            /**
             * By Mail
             * @description Whether the address is verified by a mailed link first.
             */
            by_mail: boolean;
        };
        /**
         * SignUpRequest
         * @description The address of a new account, on a server that mails a link first.
         */
        SignUpRequest: {
            /** Email */
            email: string;
        };
        /**
         * SignUpShown
         * @description The address that a mailed link opens an account for.
         */
        SignUpShown: {
            /** Email */
            email: string;
        };
        /**
         * SignatureTime
         * @description How long a contract takes from first being sent to the last signature.
         */
        SignatureTime: {
            /**
             * First Sent At
             * Format: date-time
             */
            first_sent_at: string;
            /**
             * Waits Since
             * @description Since when its next step is open; null: it waits for nobody.
             */
            waits_since: string | null;
        };
        /**
         * SignedRead
         * @description A party's yes to a text.
         */
        SignedRead: {
            party: components["schemas"]["Party"];
            /** Name */
            name: string;
            /**
             * Accepted At
             * Format: date-time
             */
            accepted_at: string;
        };
        /**
         * SignersSet
         * @description Who signs for the studio, in this order, and which party signs first.
         */
        SignersSet: {
            /** Person Ids */
            person_ids: string[];
            first?: components["schemas"]["Party"] | null;
        };
        /**
         * SigningCodeAdd
         * @description Which text a code is for.
         */
        SigningCodeAdd: {
            /** Text Sha256 */
            text_sha256: string;
        };
        /**
         * SigningCodeRead
         * @description Where a code is mailed, and how often it can be tried.
         */
        SigningCodeRead: {
            /** Email */
            email: string;
            /**
             * Expires At
             * Format: date-time
             */
            expires_at: string;
            /** Tries */
            tries: number;
        };
        /**
         * SoundBrief
         * @description The addresses of preview, peaks and spectrum of one stored sound; null if drawing it failed.
         */
        SoundBrief: {
            /** Picture Id */
            picture_id: string | null;
            /** Duration S */
            duration_s: number | null;
            thumb: components["schemas"]["ThumbRead"] | null;
            /** Preview Url */
            preview_url: string | null;
            /** Peaks Url */
            peaks_url: string | null;
            /** Spectrum Url */
            spectrum_url: string | null;
        };
        /**
         * SoundListRead
         * @description One page of the list as it stands.
         */
        SoundListRead: {
            /**
             * Revision
             * @description 0 while the list is empty and untouched.
             */
            revision: number;
            /** Cues */
            cues: components["schemas"]["CueRead"][];
            /**
             * Next
             * @description The cursor of the following page, null at the end.
             */
            next: string | null;
        };
        /**
         * Sources
         * @description What a sound was made from.
         */
        Sources: {
            /**
             * From Scratch
             * @description Synthesized or designed without any recording of others.
             * @default false
             */
            from_scratch: boolean;
            /**
             * Own Recordings
             * @description Recorded by its designer.
             * @default false
             */
            own_recordings: boolean;
            /**
             * Libraries
             * @default []
             */
            libraries: components["schemas"]["LibrarySource"][];
            /**
             * Generated
             * @default []
             */
            generated: components["schemas"]["GeneratedSource"][];
            /**
             * Performers
             * @default []
             */
            performers: components["schemas"]["PerformerSource"][];
            /**
             * Note
             * @default
             */
            note: string;
        };
        /**
         * SourcesRead
         * @description What was stated of a sound, or of a delivery.
         */
        SourcesRead: {
            sources: components["schemas"]["Sources"];
            /**
             * Stated At
             * Format: date-time
             */
            stated_at: string;
            stated_by: components["schemas"]["PersonBrief"];
            /**
             * Words
             * @description The same as one line of text.
             */
            words: string;
        };
        /**
         * SpanRead
         * @description A run of letters of one weight.
         */
        SpanRead: {
            /** Text */
            text: string;
            /** Strong */
            strong: boolean;
            /** Emphatic */
            emphatic: boolean;
        };
        /**
         * SpecApplied
         * @description The version of the delivery spec that was saved.
         */
        SpecApplied: {
            /** Version */
            version: number;
        };
        /**
         * SpecBrief
         * @description One version of the spec, without its text.
         */
        SpecBrief: {
            /** Version */
            version: number;
            /** Sha256 */
            sha256: string;
            /** Note */
            note: string;
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            author: components["schemas"]["PersonBrief"];
        };
        /**
         * SpecChange
         * @description The whole text of the spec to be.
         */
        SpecChange: {
            /** Toml */
            toml: string;
            /**
             * Note
             * @default
             */
            note: string;
            /** Based On Version */
            based_on_version: number;
        };
        /**
         * SpecChangeRead
         * @description One key of the delivery spec that an answer changes.
         */
        SpecChangeRead: {
            /**
             * Place
             * @description Dotted, as in `engine.adds`.
             */
            place: string;
            /**
             * Before
             * @description Null: the key is absent.
             */
            before: unknown;
            /**
             * After
             * @description Null: the key goes.
             */
            after: unknown;
            /** Question */
            question: string;
            /** Number */
            number: number;
            /**
             * Lines
             * @description The change as TOML.
             */
            lines: string[];
        };
        /**
         * SpecDraftCheck
         * @description A spec to look at before it is saved: its text, or its tables.
         */
        SpecDraftCheck: {
            /** Toml */
            toml?: string | null;
            /** Tables */
            tables?: {
                [key: string]: unknown;
            } | null;
        };
        /**
         * SpecDraftChecked
         * @description The text, the tables it says and what they come to, with what is probably not meant.
         */
        SpecDraftChecked: {
            /** Toml */
            toml: string;
            /** Sha256 */
            sha256: string;
            /** Tables */
            tables: {
                [key: string]: unknown;
            };
            resolved: components["schemas"]["ResolvedSpec"];
            /** Warnings */
            warnings: string[];
        };
        /**
         * SpecFormChange
         * @description The tables of the spec to be, keyed as in its TOML; null leaves a key out.
         */
        SpecFormChange: {
            /** Tables */
            tables: {
                [key: string]: unknown;
            };
            /**
             * Note
             * @default
             */
            note: string;
            /** Based On Version */
            based_on_version: number;
        };
        /**
         * SpecProposal
         * @description The delivery spec as the answers ask for it, beside the one in force.
         */
        SpecProposal: {
            /** Based On Version */
            based_on_version: number;
            /** Brief Revision */
            brief_revision: number;
            /** Toml */
            toml: string;
            /** Changes */
            changes: components["schemas"]["SpecChangeRead"][];
            /**
             * Errors
             * @description Why it cannot be saved; empty where it can.
             */
            errors: string[];
        };
        /**
         * SpecProposalApply
         * @description What the proposal was made from: it is refused where either has changed.
         */
        SpecProposalApply: {
            /** Based On Version */
            based_on_version: number;
            /** Brief Revision */
            brief_revision: number;
        };
        /**
         * SpecRead
         * @description One version of the spec: its text, the tables that the text says, and what they come to.
         */
        SpecRead: {
            /** Version */
            version: number;
            /** Sha256 */
            sha256: string;
            /** Note */
            note: string;
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            author: components["schemas"]["PersonBrief"];
            /** Toml */
            toml: string;
            /** Tables */
            tables: {
                [key: string]: unknown;
            };
            resolved: components["schemas"]["ResolvedSpec"];
            /** Warnings */
            warnings: string[];
        };
        /**
         * SpotRead
         * @description The sound around a repair, before and after, by the time of the take.
         */
        SpotRead: {
            /**
             * Kind
             * @enum {string}
             */
            kind: "gain" | "head" | "tail" | "offset";
            /** Start S */
            start_s: number;
            /** End S */
            end_s: number;
            /** After Start S */
            after_start_s: number;
            /** After End S */
            after_end_s: number;
            before: components["schemas"]["ShapeRead"];
            after: components["schemas"]["ShapeRead"];
        };
        /**
         * Stands
         * @description The position of a figure among others.
         * @enum {string}
         */
        Stands: "within" | "above" | "below";
        /**
         * StatedCueRead
         * @description A cue in the statement: how far its work is, which part of its price that makes, and by which clause.
         */
        StatedCueRead: {
            cue: components["schemas"]["ContractedCue"];
            /** Milestone */
            milestone: string;
            state: components["schemas"]["WorkState"];
            /**
             * Was Cut
             * @description It was cut before the contract ended.
             */
            was_cut: boolean;
            /** Price Minor */
            price_minor: number;
            /** Part Bp */
            part_bp: number;
            /** Owed Minor */
            owed_minor: number;
            /** Clause */
            clause: string;
        };
        /**
         * Step
         * @description One cell of the project's steps.
         */
        Step: {
            cue: components["schemas"]["CueBrief"];
            /** Palette */
            palette: boolean;
            status: components["schemas"]["CueStatus"];
        };
        /**
         * StorageRead
         * @description The storage of a studio; within a kind, the same bytes are stored and counted once.
         */
        StorageRead: {
            /**
             * Studio Id
             * Format: uuid
             */
            studio_id: string;
            /** Studio Name */
            studio_name: string;
            /** Size Bytes */
            size_bytes: number;
            /**
             * Kept
             * @description Kinds without a file are left out.
             */
            kept: components["schemas"]["KeptFiles"][];
        };
        /**
         * StudioAdd
         * @description A new studio.
         */
        StudioAdd: {
            /** Name */
            name: string;
        };
        /**
         * StudioBrief
         * @description A studio, by name.
         */
        StudioBrief: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Name */
            name: string;
        };
        /**
         * StudioInvitationAdd
         * @description The address to invite, and the role.
         */
        StudioInvitationAdd: {
            /** Email */
            email: string;
            /** Roles */
            roles: components["schemas"]["Role"][];
        };
        /**
         * StudioInvitationRead
         * @description An invitation that waits for its answer.
         */
        StudioInvitationRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Email */
            email: string;
            /** Roles */
            roles: components["schemas"]["Role"][];
            /**
             * Approves Project Id
             * @description The project that they become the approver of on joining.
             */
            approves_project_id: string | null;
            inviter: components["schemas"]["PersonBrief"];
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            /**
             * Expires At
             * Format: date-time
             */
            expires_at: string;
        };
        /**
         * StudioInvitationShown
         * @description The invitation of a link's holder.
         */
        StudioInvitationShown: {
            /** Studio Name */
            studio_name: string;
            /** Email */
            email: string;
            /** Roles */
            roles: components["schemas"]["Role"][];
            /** Invited By Name */
            invited_by_name: string;
            /** Has Account */
            has_account: boolean;
            /**
             * Expires At
             * Format: date-time
             */
            expires_at: string;
        };
        /**
         * StudioOperations
         * @description A studio's jobs, and whether a worker is running.
         */
        StudioOperations: {
            /** Counts */
            counts: components["schemas"]["JobCountRead"][];
            /** Lanes */
            lanes: components["schemas"]["LaneRead"][];
            /**
             * Workers
             * @description Worker processes that live.
             */
            workers: number;
        };
        /**
         * StudioPace
         * @description How soon the studio does its own part.
         */
        StudioPace: {
            /**
             * Review Hours
             * @description From conforming to a verdict, half of the time longer.
             */
            review_hours: number | null;
            /**
             * Answer Hours
             * @description From a question to its answer, half of the time longer.
             */
            answer_hours: number | null;
            /** Open Questions */
            open_questions: number;
            /**
             * Days To Pay
             * @description From an invoice to its last payment, half of the time longer.
             */
            days_to_pay: number | null;
            /** Late Invoices */
            late_invoices: number;
        };
        /**
         * StudioQuotas
         * @description The limits of one studio, the nearest first.
         */
        StudioQuotas: {
            /**
             * Studio Id
             * Format: uuid
             */
            studio_id: string;
            /** Studio Name */
            studio_name: string;
            /** Quotas */
            quotas: components["schemas"]["QuotaRead"][];
        };
        /**
         * SureAccept
         * @description The files of the tray to match if their names are sure.
         */
        SureAccept: {
            /**
             * Take Ids
             * @description Null: all of the tray.
             */
            take_ids?: string[] | null;
        };
        /**
         * TakeAdd
         * @description A finished upload that becomes a take; without a cue its name says which cue it is for.
         */
        TakeAdd: {
            /**
             * Upload Id
             * Format: uuid
             */
            upload_id: string;
            /**
             * File Name
             * @description Never used as a path.
             */
            file_name: string;
            /** Cue Id */
            cue_id?: string | null;
            /**
             * Variation
             * @description Of a set; null: as the name says, else the first empty one.
             */
            variation?: number | null;
            /**
             * Note
             * @default
             */
            note: string;
        };
        /**
         * TakeAdded
         * @description A delivered file as it came in.
         */
        TakeAdded: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /**
             * Project Id
             * Format: uuid
             */
            project_id: string;
            /**
             * Delivery Id
             * Format: uuid
             */
            delivery_id: string;
            designer: components["schemas"]["PersonBrief"];
            /** @description Null while it waits in the unmatched tray. */
            cue: components["schemas"]["CueBrief"] | null;
            /** Variation */
            variation: number;
            /**
             * Number
             * @description Shown as the version; null while unmatched.
             */
            number: number | null;
            /** Alternate */
            alternate: number | null;
            state: components["schemas"]["TakeState"];
            /**
             * Late
             * @description It came after its delivery was closed.
             */
            late: boolean;
            /** File Name */
            file_name: string;
            /** Note */
            note: string;
            /**
             * Fix Of Id
             * @description The version that this one is a fix of.
             */
            fix_of_id: string | null;
            /** Master Sha256 */
            master_sha256: string;
            /** Master Bytes */
            master_bytes: number;
            /**
             * Received At
             * Format: date-time
             */
            received_at: string;
            /**
             * State Since
             * Format: date-time
             */
            state_since: string;
            /**
             * Already Here
             * @description The same file was here before; this is its take.
             * @default false
             */
            already_here: boolean;
        };
        /**
         * TakeFitRead
         * @description A take compared with the approved sounds of its category, or of the palette if those are too few.
         */
        TakeFitRead: {
            /**
             * Take Id
             * Format: uuid
             */
            take_id: string;
            /** File Name */
            file_name: string;
            cue: components["schemas"]["CueBrief"] | null;
            /** @description What it is compared with; null where it is not. */
            basis: components["schemas"]["FitBasis"] | null;
            /** Category */
            category: string;
            /**
             * Says
             * @example Stands apart: louder than all of them, by 4.2 LU.
             */
            says: string;
            /** Is Apart */
            is_apart: boolean;
            /** Measures */
            measures: components["schemas"]["MeasureFit"][];
            /**
             * First Delivery Id
             * @description Its delivery, where that is the first of a designer who takes over.
             */
            first_delivery_id: string | null;
        };
        /**
         * TakeMatch
         * @description The cue that a take is for.
         */
        TakeMatch: {
            /**
             * Cue Id
             * Format: uuid
             */
            cue_id: string;
            /** Variation */
            variation?: number | null;
        };
        /**
         * TakeMove
         * @description The place of a take.
         */
        TakeMove: {
            /**
             * Take Id
             * Format: uuid
             */
            take_id: string;
            /**
             * Cue Id
             * Format: uuid
             */
            cue_id: string;
            /**
             * Variation
             * @description Of a set; null: as the name says, else the first empty one.
             */
            variation?: number | null;
        };
        /**
         * TakeRead
         * @description One delivered file; what an unmatched one is for is read from its name and the whole list.
         */
        TakeRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /**
             * Project Id
             * Format: uuid
             */
            project_id: string;
            /**
             * Delivery Id
             * Format: uuid
             */
            delivery_id: string;
            designer: components["schemas"]["PersonBrief"];
            /** @description Null while it waits in the unmatched tray. */
            cue: components["schemas"]["CueBrief"] | null;
            /** Variation */
            variation: number;
            /**
             * Number
             * @description Shown as the version; null while unmatched.
             */
            number: number | null;
            /** Alternate */
            alternate: number | null;
            state: components["schemas"]["TakeState"];
            /**
             * Late
             * @description It came after its delivery was closed.
             */
            late: boolean;
            /** File Name */
            file_name: string;
            /** Note */
            note: string;
            /**
             * Fix Of Id
             * @description The version that this one is a fix of.
             */
            fix_of_id: string | null;
            /** Master Sha256 */
            master_sha256: string;
            /** Master Bytes */
            master_bytes: number;
            /**
             * Received At
             * Format: date-time
             */
            received_at: string;
            /**
             * State Since
             * Format: date-time
             */
            state_since: string;
            /**
             * Already Here
             * @description The same file was here before; this is its take.
             * @default false
             */
            already_here: boolean;
            /**
             * Discarded At
             * @description Out of the list and the tray since then; its master is kept.
             */
            discarded_at: string | null;
            /** @description The one cue that an unmatched file is for by its name, if that is sure. */
            sure: components["schemas"]["CueGuess"] | null;
            /**
             * Guesses
             * @description Up to three cues that an unmatched file may be for otherwise.
             */
            guesses: components["schemas"]["CueGuess"][];
        };
        /**
         * TakeRename
         * @description The name of a file, and its proposed name.
         */
        TakeRename: {
            /**
             * Take Id
             * Format: uuid
             */
            take_id: string;
            /** File Name */
            file_name: string;
            /** Becomes */
            becomes: string;
        };
        /**
         * TakeSoundsRead
         * @description Everything of a take that can be played.
         */
        TakeSoundsRead: {
            /**
             * Take Id
             * Format: uuid
             */
            take_id: string;
            master: components["schemas"]["MasterSoundRead"];
            /** @description Its newest fixed copy, once it is drawn. */
            fix: components["schemas"]["SoundBrief"] | null;
            /** Renders */
            renders: components["schemas"]["RenderSoundRead"][];
            /**
             * Closed
             * @description Why masters and game files cannot be downloaded now, where the contract opens them by payment.
             */
            closed: string | null;
        };
        /**
         * TakeSources
         * @description The sources of one take.
         */
        TakeSources: {
            /**
             * Take Id
             * Format: uuid
             */
            take_id: string;
            /** @description Its own statement, else that of its delivery; null: none. */
            stated: components["schemas"]["SourcesRead"] | null;
            /**
             * Is Own
             * @description Whether the take has a statement of its own.
             */
            is_own: boolean;
            /**
             * Is Fixed
             * @description Whether they are on record: the take is approved, and nothing is open.
             */
            is_fixed: boolean;
            /**
             * Open Points
             * @description What a clearance asks for and is not stated.
             */
            open_points: string[];
        };
        /**
         * TakeState
         * @description The state of a take.
         * @enum {string}
         */
        TakeState: "received" | "conforming" | "returned" | "unjudged" | "approved" | "change_requested" | "set_aside";
        /**
         * TakeStateRead
         * @description A take and its state.
         */
        TakeStateRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Variation */
            variation: number;
            state: components["schemas"]["TakeState"];
        };
        /**
         * TakesMove
         * @description The places of takes.
         */
        TakesMove: {
            /** Moves */
            moves: components["schemas"]["TakeMove"][];
        };
        /**
         * TakesNamed
         * @description Takes that something is done to at once.
         */
        TakesNamed: {
            /** Take Ids */
            take_ids: string[];
        };
        /**
         * TargetMemory
         * @description The format of a target's game files, and their memory in the game.
         */
        TargetMemory: {
            /** Name */
            name: string;
            /**
             * Engine
             * @description Whose preset bears this name.
             */
            engine: string | null;
            /**
             * Accepts
             * @description What that engine imports.
             */
            accepts: string | null;
            /** Why */
            why: string | null;
            /** Sample Rate Hz */
            sample_rate_hz: number;
            /** Bit Depth */
            bit_depth: number;
            /** Encoding */
            encoding: string;
            /**
             * Channels
             * @enum {unknown}
             */
            channels: "master" | 1 | 2;
            /** Dither */
            dither: string;
            /** Folder */
            folder: string;
            /** Codec Ratio */
            codec_ratio: number;
            /** Streamed */
            streamed: boolean;
            /** @description Of the accepted sounds, as their files are. */
            used: components["schemas"]["MemoryByCategory"];
            /** @description Those, and the rest of the list by the lengths that it asks for. */
            forecast: components["schemas"]["MemoryByCategory"];
        };
        /**
         * TargetRead
         * @description The format of renders.
         */
        TargetRead: {
            /** Name */
            name: string;
            /** Sample Rate Hz */
            sample_rate_hz: number;
            /** Bit Depth */
            bit_depth: number;
            /** Encoding */
            encoding: string;
            /**
             * Channels
             * @enum {unknown}
             */
            channels: "master" | 1 | 2;
            /** Dither */
            dither: string;
            /** Over Peak */
            over_peak: string;
        };
        /**
         * TargetsRead
         * @description The targets of the newest spec, and what there is to start from.
         */
        TargetsRead: {
            /** Targets */
            targets: components["schemas"]["TargetMemory"][];
            /** Presets */
            presets: components["schemas"]["PresetRead"][];
        };
        /**
         * TaxRead
         * @description The tax of one rate on an invoice.
         */
        TaxRead: {
            /** Tax Bp */
            tax_bp: number;
            /** Amount Minor */
            amount_minor: number;
        };
        /**
         * TemplateAdd
         * @description A template to keep.
         */
        TemplateAdd: {
            /** Name */
            name: string;
            kind: components["schemas"]["ContractKind"];
            /** Clauses */
            clauses: components["schemas"]["ClauseRow"][];
            /** Terms */
            terms: {
                [key: string]: number | string;
            };
        };
        /**
         * TemplateBrief
         * @description A template that the studio keeps.
         */
        TemplateBrief: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Name */
            name: string;
            kind: components["schemas"]["ContractKind"];
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            /**
             * Changed At
             * Format: date-time
             */
            changed_at: string;
        };
        /**
         * TemplateChange
         * @description What a template is to say.
         */
        TemplateChange: {
            /** Name */
            name: string;
            /** Clauses */
            clauses: components["schemas"]["ClauseRow"][];
            /** Terms */
            terms: {
                [key: string]: number | string;
            };
        };
        /**
         * TemplateImport
         * @description A template as TOML; under another name if one is given.
         */
        TemplateImport: {
            /** Toml */
            toml: string;
            /** Name */
            name?: string | null;
        };
        /**
         * TemplateRead
         * @description A template with its clauses and terms.
         */
        TemplateRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Name */
            name: string;
            kind: components["schemas"]["ContractKind"];
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            /**
             * Changed At
             * Format: date-time
             */
            changed_at: string;
            /** Clauses */
            clauses: components["schemas"]["ClauseRow"][];
            /** Terms */
            terms: {
                [key: string]: number | string;
            };
        };
        /**
         * TermRead
         * @description What a clause leaves open: `_bp` ends a part in basis points, `_minor` an amount in minor units.
         */
        TermRead: {
            /** Name */
            name: string;
            /** Default */
            default: number | string;
            /** Label */
            label: string;
            /** Min */
            min: number | null;
            /** Max */
            max: number | null;
            /**
             * Choices
             * @description Empty where any value does.
             */
            choices: components["schemas"]["ChoiceRead"][];
        };
        /**
         * ThumbRead
         * @description The shape of a sound in a row of a list: integers, ±127 is full scale.
         */
        ThumbRead: {
            /** Points */
            points: number;
            /** Min */
            min: number[];
            /** Max */
            max: number[];
            /** Rms */
            rms: number[];
        };
        /**
         * ToMake
         * @description A cue that waits for a file from the designer.
         */
        ToMake: {
            cue: components["schemas"]["CueBrief"];
            /** Use */
            use: string;
            /** Category */
            category: string;
            /** Duration S */
            duration_s: number | null;
            /** Loop */
            loop: boolean;
            /** Variations */
            variations: number;
            /** Missing */
            missing: number;
            /** State */
            state: string;
            status: components["schemas"]["CueStatus"];
        };
        /**
         * Today
         * @description What waits for the team today, besides the review queue.
         */
        Today: {
            /** Questions */
            questions: components["schemas"]["AskedQuestion"][];
            /** With Others */
            with_others: components["schemas"]["WithOthers"][];
            /** Builds */
            builds: components["schemas"]["BuildBrief"][];
            /** Counts */
            counts: {
                [key: string]: number;
            };
            /** Draft Changes */
            draft_changes: number;
            /** Placeholders */
            placeholders: number;
            /** Unsent Mails */
            unsent_mails: number;
        };
        /**
         * TokenAdd
         * @description The purpose and rights of a build's token.
         */
        TokenAdd: {
            /** Name */
            name: string;
            /** Scopes */
            scopes: components["schemas"]["Scope"][];
        };
        /**
         * TokenMade
         * @description A new key with its secret, which is shown this once.
         */
        TokenMade: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Name */
            name: string;
            /** Scopes */
            scopes: components["schemas"]["Scope"][];
            creator: components["schemas"]["PersonBrief"];
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            /** Last Used At */
            last_used_at: string | null;
            /** Revoked At */
            revoked_at: string | null;
            /** Secret */
            secret: string;
        };
        /**
         * TokenRead
         * @description A build's key, without its secret.
         */
        TokenRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Name */
            name: string;
            /** Scopes */
            scopes: components["schemas"]["Scope"][];
            creator: components["schemas"]["PersonBrief"];
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            /** Last Used At */
            last_used_at: string | null;
            /** Revoked At */
            revoked_at: string | null;
        };
        /**
         * TrayActionKind
         * @description The actions on many takes at once.
         * @enum {string}
         */
        TrayActionKind: "matched" | "moved" | "discarded" | "restored";
        /**
         * TrayActionRead
         * @description One action on many takes at once.
         */
        TrayActionRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            kind: components["schemas"]["TrayActionKind"];
            /**
             * Done At
             * Format: date-time
             */
            done_at: string;
            /** Undone At */
            undone_at: string | null;
            /**
             * Take Ids
             * @description The takes that changed.
             */
            take_ids: string[];
        };
        /**
         * TrayActionUndone
         * @description The undone action.
         */
        TrayActionUndone: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            kind: components["schemas"]["TrayActionKind"];
            /**
             * Done At
             * Format: date-time
             */
            done_at: string;
            /** Undone At */
            undone_at: string | null;
            /**
             * Take Ids
             * @description The takes that changed.
             */
            take_ids: string[];
            /**
             * Moved Back
             * @description Takes that are where they were before.
             */
            moved_back: number;
            /**
             * Left
             * @description Takes that were changed or decided since; they stay as they are.
             */
            left: number;
        };
        /**
         * UnclearCue
         * @description A cue that a designer could not make from its words, with what they leave open.
         */
        UnclearCue: {
            /**
             * Cue Id
             * Format: uuid
             */
            cue_id: string;
            /** Questions */
            questions: components["schemas"]["FactQuestion"][];
        };
        /**
         * UploadRead
         * @description A file on its way in, or arrived.
         */
        UploadRead: {
            /**
             * Upload Id
             * Format: uuid
             */
            upload_id: string;
            /**
             * Offset
             * @description How many bytes are here.
             */
            offset: number;
            /** Length */
            length: number;
            /**
             * Sha256
             * @description Null until the last byte is here.
             */
            sha256: string | null;
        };
        /**
         * Urgency
         * @description The urgency of a lane's jobs: those that people wait for go before a re-render of thousands.
         * @enum {string}
         */
        Urgency: "urgent" | "normal" | "bulk";
        /**
         * UsualRange
         * @description From and to: a guess, until the studio has a history of its own.
         */
        UsualRange: {
            /** Low */
            low: number;
            /** High */
            high: number;
        };
        /** ValidationError */
        ValidationError: {
            /** Location */
            loc: (string | number)[];
            /** Message */
            msg: string;
            /** Error Type */
            type: string;
            /** Input */
            input?: unknown;
            /** Context */
            ctx?: Record<string, never>;
        };
        /**
         * VariationProgress
         * @description The status of one variation of a cue.
         */
        VariationProgress: {
            /** Variation */
            variation: number;
            /** Stem */
            stem: string;
            status: components["schemas"]["CueStatus"];
        };
        /**
         * VerdictGive
         * @description A verdict on one take.
         */
        VerdictGive: {
            /**
             * Kind
             * @enum {string}
             */
            kind: "approve" | "request_change" | "set_aside";
            /**
             * Note
             * @default
             */
            note: string;
            /** Start S */
            start_s?: number | null;
            /** End S */
            end_s?: number | null;
            /**
             * @description Where the page showed the take; another state now is answered 409 and changes nothing. Say `set_aside` to pick a take later, `approved` to reverse an approval.
             * @default conforming
             */
            seen_state: components["schemas"]["TakeState"];
        };
        /**
         * VerdictGiven
         * @description The decisions of one click.
         */
        VerdictGiven: {
            /**
             * Take Id
             * Format: uuid
             */
            take_id: string;
            state: components["schemas"]["TakeState"];
            /**
             * Set Aside
             * @description Other takes of the same variation that gave way.
             */
            set_aside: string[];
            draft: components["schemas"]["ChangeRequestRead"] | null;
            /**
             * Cue Id
             * Format: uuid
             */
            cue_id: string;
            /** Cue Accepted */
            cue_accepted: boolean;
            /**
             * Undo Until
             * @description Null for a draft, which can be dropped until it is sent.
             */
            undo_until: string | null;
        };
        /**
         * VerdictKind
         * @description The approver's verdict on a take.
         * @enum {string}
         */
        VerdictKind: "approve" | "request_change" | "set_aside" | "withdraw";
        /**
         * VerdictRead
         * @description One verdict on record.
         */
        VerdictRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /**
             * Take Id
             * Format: uuid
             */
            take_id: string;
            kind: components["schemas"]["VerdictKind"];
            /** Note */
            note: string;
            /** @description Null where a clause on silence decided it. */
            given_by: components["schemas"]["PersonBrief"] | null;
            /** @description The approver whose deputy decided; null in one's own right. */
            on_behalf_of: components["schemas"]["PersonBrief"] | null;
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            /**
             * By Deemed Acceptance
             * @description Whether a clause on silence decided it; then nobody did.
             */
            by_deemed_acceptance: boolean;
            /** Withdrawn */
            withdrawn: boolean;
        };
        /**
         * VerdictUndone
         * @description The state restored after a verdict was undone.
         */
        VerdictUndone: {
            /** Takes */
            takes: components["schemas"]["TakeStateRead"][];
            /** Draft Dropped */
            draft_dropped: boolean;
        };
        /**
         * VerifiedRead
         * @description What a file is, compared with the seals of this server.
         */
        VerifiedRead: {
            /**
             * Verdict
             * @enum {string}
             */
            verdict: "untouched" | "changed" | "not_ours";
            /** File Sha256 */
            file_sha256: string;
            /** @description What it binds; null unless it is untouched. */
            binds: components["schemas"]["BoundRead"] | null;
        };
        /**
         * VersionBrief
         * @description One version of a contract's text.
         */
        VersionBrief: {
            /** Number */
            number: number;
            /** Note */
            note: string;
            author: components["schemas"]["PersonBrief"];
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            /** Sent At */
            sent_at: string | null;
            /** Text Sha256 */
            text_sha256: string;
            /** Pdf Sha256 */
            pdf_sha256: string | null;
        };
        /**
         * VersionRead
         * @description One version with its text; what it was written from is the studio's alone.
         */
        VersionRead: {
            /** Number */
            number: number;
            /** Note */
            note: string;
            author: components["schemas"]["PersonBrief"];
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            /** Sent At */
            sent_at: string | null;
            /** Text Sha256 */
            text_sha256: string;
            /** Pdf Sha256 */
            pdf_sha256: string | null;
            /** Blocks */
            blocks: components["schemas"]["BlockRead"][];
            /** Clauses */
            clauses: components["schemas"]["ClauseRow"][];
            /** Terms */
            terms: {
                [key: string]: number | string;
            };
        };
        /**
         * WaivedSound
         * @description Codes that the approver let through for one sound, found by the hash of its samples.
         */
        WaivedSound: {
            /** Pcm Sha256 */
            pcm_sha256: string;
            /** Codes */
            codes: string[];
            /** Reason */
            reason: string;
            /** Cue */
            cue: string | null;
            /** File Name */
            file_name: string;
        };
        /**
         * WaiverAdd
         * @description Why a returned take is let through.
         */
        WaiverAdd: {
            /** Reason */
            reason: string;
        };
        /**
         * WaiverRead
         * @description That the approver let a returned take through, and why.
         */
        WaiverRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Codes */
            codes: string[];
            /** Reason */
            reason: string;
            waived_by: components["schemas"]["PersonBrief"];
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
        };
        /**
         * WithApprover
         * @description A cue that waits for its verdict.
         */
        WithApprover: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /**
             * Label
             * @example SW-014
             */
            label: string;
            /** Name */
            name: string;
            /**
             * Accepted After
             * @description Day after which it counts as accepted without a verdict, by its contract's clause on silence.
             */
            accepted_after: string | null;
            /**
             * Silence Paused By
             * @description What is open, so that the days of the clause do not count.
             */
            silence_paused_by: ("question" | "change_order") | null;
        };
        /**
         * WithOthers
         * @description What waits for another person.
         */
        WithOthers: {
            cue: components["schemas"]["CueBrief"] | null;
            /** File Name */
            file_name: string;
            /**
             * Status
             * @enum {string}
             */
            status: "returned" | "unmatched" | "change_requested" | "unjudged";
            /** Who */
            who: string;
            /**
             * Person Id
             * Format: uuid
             */
            person_id: string;
            /**
             * Since
             * Format: date-time
             */
            since: string;
        };
        /**
         * WordingRead
         * @description A wording as it was written.
         */
        WordingRead: {
            /**
             * Title
             * @default
             */
            title: string;
            /**
             * Text
             * @default
             */
            text: string;
            /**
             * Terms
             * @description Values that change, by name.
             * @default {}
             */
            terms: {
                [key: string]: number | string;
            };
        };
        /**
         * WorkLogAdd
         * @description Time that went into a cue.
         */
        WorkLogAdd: {
            /**
             * Cue Id
             * Format: uuid
             */
            cue_id: string;
            /** Minutes */
            minutes: number;
            /**
             * Worked On
             * Format: date
             */
            worked_on: string;
        };
        /**
         * WorkState
         * @description How far the work on a cue was when it was cut.
         * @enum {string}
         */
        WorkState: "not_begun" | "in_work" | "delivered" | "accepted";
        /**
         * WorkedDayAdd
         * @description A day, or quarters of one, under a contract by the day.
         */
        WorkedDayAdd: {
            /**
             * Worked On
             * Format: date
             */
            worked_on: string;
            /**
             * Quarters
             * @default 4
             */
            quarters: number;
            /**
             * Note
             * @default
             */
            note: string;
        };
        /**
         * WorkedDayRead
         * @description A logged day; due once the studio has agreed.
         */
        WorkedDayRead: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /**
             * Worked On
             * Format: date
             */
            worked_on: string;
            /** Quarters */
            quarters: number;
            /** Note */
            note: string;
            /** Amount Minor */
            amount_minor: number;
            /** Agreed At */
            agreed_at: string | null;
        };
        /**
         * WorkerRead
         * @description A worker process, its last heartbeat, and the number of jobs that it is running.
         */
        WorkerRead: {
            /** Id */
            id: string;
            /**
             * Beat At
             * Format: date-time
             */
            beat_at: string;
            /**
             * Is Alive
             * @description Whether it said so lately; the jobs of one that is silent others take over.
             */
            is_alive: boolean;
            /** Running */
            running: number;
        };
        /**
         * WornCue
         * @description A cue that took too many rounds, and is not accepted yet.
         */
        WornCue: {
            /**
             * Cue Id
             * Format: uuid
             */
            cue_id: string;
            /** Label */
            label: string;
            /** Name */
            name: string;
            /** Rounds */
            rounds: number;
        };
        /**
         * AnswerKind
         * @description What the studio says to a redline.
         * @enum {string}
         */
        app__agreements__redline_rules__AnswerKind: "accepted" | "refused" | "countered";
        /**
         * AnswerKind
         * @description What an answer is made of.
         * @enum {string}
         */
        app__briefs__questions__AnswerKind: "choice" | "choices" | "text" | "number" | "lines" | "per_category" | "per_scene" | "names";
    };
    responses: never;
    parameters: never;
    requestBodies: never;
    headers: never;
    pathItems: never;
}
export type $defs = Record<string, never>;
export interface operations {
    read_session: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SessionRead"];
                };
            };
        };
    };
    play_demo_part: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                part: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["DemoPart"];
                };
            };
            /** @description `demo-unavailable` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    sign_in: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["SignInAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PersonRead"];
                };
            };
            /** @description `wrong-sign-in` */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
            /** @description `too-many-attempts` */
            429: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    sign_out: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    read_sign_up: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SignUpMode"];
                };
            };
        };
    };
    sign_up: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["SignUpAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PersonRead"];
                };
            };
            /** @description `sign-up-closed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `address-taken`, `verification-needed` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-address`, `password-too-weak` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `too-many-attempts` */
            429: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    read_sign_up_link: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                secret: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SignUpShown"];
                };
            };
            /** @description `sign-up-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    finish_sign_up: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                secret: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["SignUpFinish"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PersonRead"];
                };
            };
            /** @description `sign-up-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `address-taken` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `password-too-weak` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    request_sign_up: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["SignUpRequest"];
            };
        };
        responses: {
            /** @description Successful Response */
            202: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": unknown;
                };
            };
            /** @description `sign-up-closed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `no-mail-server` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-address` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `too-many-attempts` */
            429: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    request_password_reset: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["ResetAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            202: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": unknown;
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
            /** @description `too-many-attempts` */
            429: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    set_password_by_link: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                secret: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["NewPassword"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PersonRead"];
                };
            };
            /** @description `reset-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `password-too-weak` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    read_me: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Me"];
                };
            };
        };
    };
    change_my_name: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["NameChange"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PersonRead"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    list_my_sign_ins: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SignInRead"][];
                };
            };
        };
    };
    end_my_other_sign_ins: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    end_my_sign_in: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                sign_in_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description `sign-in-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    request_email_verification: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            202: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": unknown;
                };
            };
            /** @description `not-in-demo` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `already-verified` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `too-many-attempts` */
            429: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    verify_email: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                secret: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PersonRead"];
                };
            };
            /** @description `verification-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    change_my_password: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["PasswordChange"];
            };
        };
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description `wrong-password`, `not-in-demo` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `password-too-weak` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `too-many-attempts` */
            429: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    create_studio: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["StudioAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["StudioBrief"];
                };
            };
            /** @description `not-in-demo` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    list_people: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                studio_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["MemberRead"][];
                };
            };
            /** @description `studio-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    change_member_roles: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                studio_id: string;
                person_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["RolesChange"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["MemberRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `studio-not-found`, `member-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `last-producer` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    remove_member: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                studio_id: string;
                person_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `studio-not-found`, `member-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `last-producer` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    list_studio_invitations: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                studio_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["StudioInvitationRead"][];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `studio-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    invite_member: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                studio_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["StudioInvitationAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["StudioInvitationRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `studio-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `already-member` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-address` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `too-many-attempts` */
            429: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    revoke_studio_invitation: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                studio_id: string;
                studio_invitation_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `studio-not-found`, `studio-invitation-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    read_studio_invitation: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                secret: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["StudioInvitationShown"];
                };
            };
            /** @description `studio-invitation-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    accept_studio_invitation: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                secret: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["InvitationAccept"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["JoinedStudio"];
                };
            };
            /** @description `sign-in-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `studio-invitation-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `name-needed`, `password-too-weak` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `too-many-attempts` */
            429: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_studio_calendar: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                studio_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["CalendarRead"];
                };
            };
            /** @description `studio-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    save_studio_calendar: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                studio_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["CalendarSave"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["CalendarRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `studio-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `time-zone-unknown`, `day-named-twice` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    list_projects: {
        parameters: {
            query?: {
                cursor?: string | null;
                /** @description Archived projects instead of the running ones. */
                archived?: boolean;
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Page_ProjectRead_"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    create_project: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["ProjectAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ProjectRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `studio-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    read_project: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ProjectRead"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    change_project: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["ProjectChange"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ProjectRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    get_project_calendar: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["CalendarRead"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    add_liaison: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
                person_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ProjectRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found`, `liaison-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    remove_liaison: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
                person_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ProjectRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found`, `liaison-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `liaison-is-approver` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    name_approver: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["ApproverAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ProjectRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `cannot-approve` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    invite_approver: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["ApproverInvite"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ApproverInvited"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-address` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `too-many-attempts` */
            429: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    list_approver_changes: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ApproverChangeRead"][];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    list_invitations: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["InvitationRead"][];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    invite_designer: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["InvitationAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["InvitationRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `already-engaged` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-address` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `too-many-attempts` */
            429: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    revoke_invitation: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
                invitation_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found`, `invitation-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    change_engagement: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
                engagement_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["EngagementChange"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["EngagementRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found`, `engagement-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    list_tokens: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TokenRead"][];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    create_token: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["TokenAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TokenMade"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    revoke_token: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
                token_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found`, `token-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    accept_invitation: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                secret: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["InvitationAccept"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["InvitationAccepted"];
                };
            };
            /** @description `sign-in-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `invitation-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `name-needed`, `password-too-weak` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `too-many-attempts` */
            429: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    name_category_approver: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["CategoryApproverName"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ProjectRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `cannot-approve` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    list_deputies: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["DeputiesRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    name_deputy: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["DeputyAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["DeputyRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `cannot-approve`, `bad-deputy` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    withdraw_deputy: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
                deputy_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found`, `deputy-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    read_spec: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SpecRead"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    save_spec: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["SpecChange"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SpecRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `spec-changed` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-spec` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `parsing-busy` */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    download_spec: {
        parameters: {
            query?: never;
            header?: {
                "if-none-match"?: string | null;
            };
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/plain": string;
                };
            };
            /** @description the copy that was named in If-None-Match is good */
            304: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/plain": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    list_spec_versions: {
        parameters: {
            query?: {
                cursor?: string | null;
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Page_SpecBrief_"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-cursor` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    read_spec_version: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
                version: number;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SpecRead"];
                };
            };
            /** @description `project-not-found`, `spec-version-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    save_spec_form: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["SpecFormChange"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SpecRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `spec-changed` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-spec` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `parsing-busy` */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    check_spec_draft: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["SpecDraftCheck"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SpecDraftChecked"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-spec` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `parsing-busy` */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    read_brief: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["BriefDocument"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    change_brief: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["BriefChange"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["BriefDocument"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `answer-changed` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `answer-invalid`, `question-unknown` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    list_brief_versions: {
        parameters: {
            query?: {
                cursor?: string | null;
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Page_BriefVersionSummary_"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-cursor` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    publish_brief_version: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["BriefVersionAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["BriefVersionSummary"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `nothing-to-publish`, `answer-changed` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    read_brief_version: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
                version: number;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["BriefVersionRead"];
                };
            };
            /** @description `project-not-found`, `brief-version-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    record_brief_read: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
                version: number;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description `designer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found`, `brief-version-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    list_brief_reads: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["LastReadRead"][];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    compare_brief_versions: {
        parameters: {
            query?: {
                from?: number;
                /** @description Left out: the brief as it stands. */
                to?: number | null;
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["BriefComparison"];
                };
            };
            /** @description `project-not-found`, `brief-version-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    propose_spec: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SpecProposal"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    apply_spec_proposal: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["SpecProposalApply"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SpecApplied"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `answer-changed`, `nothing-proposed`, `spec-changed` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-spec` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    ask_follow_up: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["FollowUpAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["FollowUpRead"];
                };
            };
            /** @description `designer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `question-unknown` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    answer_follow_up: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                follow_up_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["FollowUpAnswer"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["FollowUpRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `follow-up-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `follow-up-answered` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    check_clarity: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ClarityRead"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    answer_fact: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                cue_id: string;
                fact: components["schemas"]["Fact"];
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["FactAnswer"];
            };
        };
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `cue-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `cue-is-cut` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `rows-invalid` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    dismiss_fact: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                cue_id: string;
                fact: components["schemas"]["Fact"];
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["FactDismissal"];
            };
        };
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `cue-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    get_sound_list: {
        parameters: {
            query?: {
                cursor?: string | null;
                /** @description How many cues to answer at most. */
                limit?: number;
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SoundListRead"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-cursor` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    list_categories: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["CategoryCount"][];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    export_sound_list: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/csv": string;
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    add_cues: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["CuesAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["CueRead"][];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `rows-invalid` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_cue: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                cue_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["CueDetail"];
                };
            };
            /** @description `cue-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    change_cue: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                cue_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["CuePatch"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["CueRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `cue-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `cue-changed`, `cue-is-cut` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `rows-invalid` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    flag_placeholder: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                cue_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["PlaceholderSet"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["CueRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `cue-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `cue-is-cut` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    flag_palette: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                cue_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["PaletteSet"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["CueRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `cue-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `cue-is-cut` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    order_cues: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["CueOrder"];
            };
        };
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `order-invalid` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    import_sound_list: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["ImportAsk"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ImportRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `sheet-unreadable`, `column-unknown` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `parsing-busy` */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    list_revisions: {
        parameters: {
            query?: {
                cursor?: number | null;
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Page_RevisionRead_"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    compare_revisions: {
        parameters: {
            query: {
                from: number;
                to: number;
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ListComparison"];
                };
            };
            /** @description `project-not-found`, `revision-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    list_questions: {
        parameters: {
            query?: {
                only_open?: boolean;
                cursor?: string | null;
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Page_QuestionRead_"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    ask_question: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                cue_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["QuestionAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["QuestionRead"];
                };
            };
            /** @description `cue-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    answer_question: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                question_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["AnswerAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["QuestionRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `question-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `question-answered` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    preview_invitation: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                secret: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["InvitationPreview"];
                };
            };
            /** @description `invitation-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    read_coverage: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["CoverageRead"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    list_kits: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["KitRead"][];
                };
            };
        };
    };
    read_kit: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
                kit_key: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["KitRows"];
                };
            };
            /** @description `project-not-found`, `kit-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    undo_cue_addition: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["AdditionUndo"];
            };
        };
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `addition-in-use` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    list_postings: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PostingSummary"][];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    create_posting: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["PostingAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PostingRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `posting-invalid` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    list_my_postings: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PostingSummary"][];
                };
            };
        };
    };
    read_posting: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                posting_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PostingRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `posting-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    change_posting: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                posting_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["PostingChange"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PostingRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `posting-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `posting-changed`, `wrong-posting-state` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `posting-invalid` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    open_posting: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                posting_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PostingRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `posting-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `wrong-posting-state` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `posting-invalid` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    close_posting: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                posting_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PostingRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `posting-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `wrong-posting-state` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    invite_candidate: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                posting_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["CandidateAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PostingRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `posting-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `wrong-posting-state` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-address` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `too-many-attempts` */
            429: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    withdraw_candidate: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                posting_id: string;
                candidate_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `posting-not-found`, `candidate-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    make_posting_link: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                posting_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PostingLink"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `posting-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    revoke_posting_link: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                posting_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `posting-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    preview_posting: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                secret: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PostingPreview"];
                };
            };
            /** @description `posting-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    join_posting: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                secret: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PostingJoined"];
                };
            };
            /** @description `posting-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `link-taken`, `own-posting` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    ask_for_posting_link: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                secret: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["CandidateAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            202: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": unknown;
                };
            };
            /** @description `posting-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `posting-closed` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-address` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `too-many-attempts` */
            429: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    open_account_by_posting_link: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                secret: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["InvitationAccept"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PersonRead"];
                };
            };
            /** @description `sign-in-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `posting-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `personal-link-needed` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `name-needed`, `password-too-weak` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `too-many-attempts` */
            429: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    save_bid: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                posting_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["BidWrite"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PostingRead"];
                };
            };
            /** @description `designer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `posting-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `posting-closed`, `bid-changed` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bid-invalid` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    send_bid: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                posting_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["BidSend"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PostingRead"];
                };
            };
            /** @description `designer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `posting-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `posting-closed`, `bid-changed`, `bid-not-sent` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bid-invalid` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    withdraw_bid: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                posting_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PostingRead"];
                };
            };
            /** @description `designer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `posting-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bid-not-sent` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    ask_about_posting: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                posting_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["PostingQuestionAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PostingRead"];
                };
            };
            /** @description `designer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `posting-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    answer_posting_question: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                posting_question_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["PostingQuestionAnswer"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PostingRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `posting-question-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `posting-question-answered` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    compare_bids: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                posting_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["BidComparison"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `posting-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    shortlist_bid: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                bid_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["ShortlistWrite"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["BidComparison"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bid-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bid-not-sent` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    score_bid: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                bid_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["ScoresWrite"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["BidComparison"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bid-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bid-not-sent` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `scores-invalid` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    award_posting: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                bid_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PostingAwarded"];
                };
            };
            /** @description `team-needed`, `producer-needed`, `same-person-on-both-sides` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bid-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bid-not-sent`, `wrong-posting-state`, `no-contract-needed` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    read_plan: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PlanRead"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    save_plan: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["PlanSet"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PlanRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `plan-locked` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-plan` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    propose_plan: {
        parameters: {
            query?: {
                total_minor?: number | null;
            };
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PlanProposal"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    check_plan: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["PlanSet"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PlanChecked"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    say_game_shipped: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Shipped"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["LedgerRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `no-shipping-bonus` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `day-in-future` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    read_ledger: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["LedgerRead"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    read_extra_rounds: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ExtraRoundRead"][];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    agree_extra_round: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                extra_round_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ExtraRoundRead"];
                };
            };
            /** @description `other-party-needed`, `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `extra-round-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `round-already-settled` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    drop_extra_round: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                extra_round_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ExtraRoundRead"];
                };
            };
            /** @description `other-party-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `extra-round-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `round-already-settled` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    read_invoice_draft: {
        parameters: {
            query?: {
                full_number?: string;
            };
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["InvoiceDraft"];
                };
            };
            /** @description `other-party-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `not-agreed`, `nothing-to-invoice` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    list_invoices: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["InvoiceRead"][];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    issue_invoice: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["InvoiceIssue"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["InvoiceRead"];
                };
            };
            /** @description `other-party-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `not-agreed`, `nothing-to-invoice`, `invoice-number-taken` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    read_invoice: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                invoice_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["InvoiceRead"];
                };
            };
            /** @description `invoice-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    read_invoice_pdf: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                invoice_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The invoice */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/pdf": unknown;
                };
            };
            /** @description `invoice-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `document-too-large` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `typesetting-busy` */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    charge_late_interest: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                invoice_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["InvoiceRead"];
                };
            };
            /** @description `other-party-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `invoice-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `no-interest-due` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    record_payment: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                invoice_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["PaymentAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["InvoiceRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `invoice-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `overpayment`, `day-in-future` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    refund_payment: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                payment_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["PaymentAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["InvoiceRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `payment-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `refund-too-large`, `day-in-future` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    read_cue_money: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                cue_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["CueMoneyRead"] | null;
                };
            };
            /** @description `cue-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    read_estimates: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["EstimatesRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    log_work: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["WorkLogAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description `other-party-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found`, `cue-not-in-contract` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `not-agreed` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    list_worked_days: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["WorkedDayRead"][];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    log_day: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["WorkedDayAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["WorkedDayRead"];
                };
            };
            /** @description `other-party-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `not-agreed`, `not-day-rate`, `day-agreed` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `day-in-future` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    drop_day: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                worked_day_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description `other-party-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `worked-day-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `day-agreed` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    agree_day: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                worked_day_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["WorkedDayRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `worked-day-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `day-agreed`, `cap-exceeded` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    make_calendar: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["CalendarLinkMade"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    withdraw_calendar: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    read_calendar: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                secret: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Dates */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/calendar": unknown;
                };
            };
            /** @description `calendar-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    read_contract_library: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                kind: components["schemas"]["ContractKind"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["LibraryRead"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    download_library_template: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                kind: components["schemas"]["ContractKind"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/plain": string;
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    list_contract_templates: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                studio_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TemplateBrief"][];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `studio-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    add_contract_template: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                studio_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["TemplateAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TemplateRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `studio-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `template-name-taken` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-template` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    import_contract_template: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                studio_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["TemplateImport"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TemplateRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `studio-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `template-name-taken` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-template` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `parsing-busy` */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    read_contract_template: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                studio_id: string;
                template_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TemplateRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `studio-not-found`, `template-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    change_contract_template: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                studio_id: string;
                template_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["TemplateChange"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TemplateRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `studio-not-found`, `template-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `template-name-taken` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-template` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    drop_contract_template: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                studio_id: string;
                template_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `studio-not-found`, `template-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    download_contract_template: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                studio_id: string;
                template_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/plain": string;
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/plain": components["schemas"]["Problem"];
                };
            };
            /** @description `studio-not-found`, `template-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/plain": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    download_contract_template_text: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                studio_id: string;
                template_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/plain": string;
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/plain": components["schemas"]["Problem"];
                };
            };
            /** @description `studio-not-found`, `template-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/plain": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    save_contract_as_template: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["ContractTemplateAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TemplateRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `template-name-taken` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-template` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    list_contracts: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ContractBrief"][];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    create_contract: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["ContractAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ContractRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found`, `engagement-not-found`, `template-not-found`, `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `no-contract-needed` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `framework-needed` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    read_last_contract: {
        parameters: {
            query: {
                engagement_id: string;
                kind?: components["schemas"]["ContractKind"];
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["LastContractRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found`, `engagement-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    read_contract: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ContractRead"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    save_contract_draft: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["DraftSave"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ContractRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `wrong-state`, `draft-changed` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-draft` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    preview_contract: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["DraftChange"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["DraftPreview"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    send_contract: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["SendAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ContractRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `brief-open`, `draft-changed`, `redlines-open`, `wrong-state` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `document-too-large` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `typesetting-busy` */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    recall_contract: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["RecallAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ContractRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `wrong-state` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    request_contract_change: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["ContractChangeAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ContractRead"];
                };
            };
            /** @description `not-your-contract` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `wrong-state` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    set_contract_signers: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["SignersSet"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ContractRead"];
                };
            };
            /** @description `producer-needed`, `not-a-signer` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `wrong-state` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `too-many-signers` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    accept_contract: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["AcceptAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ContractRead"];
                };
            };
            /** @description `not-your-contract`, `not-a-signer`, `address-not-proven`, `same-person-on-both-sides`, `signing-code-needed`, `wrong-signing-code` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `wrong-state`, `not-your-turn`, `already-accepted`, `signing-code-over`, `text-changed` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    end_contract: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["EndAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ContractRead"];
                };
            };
            /** @description `not-your-contract` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `wrong-state`, `notice-needed` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    request_signing_code: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["SigningCodeAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SigningCodeRead"];
                };
            };
            /** @description `not-your-contract`, `address-not-proven` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `no-signing-code` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
            /** @description `too-many-attempts` */
            429: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    list_contract_versions: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["VersionBrief"][];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    read_contract_version: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
                version: number;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["VersionRead"];
                };
            };
            /** @description `contract-not-found`, `contract-version-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    download_contract_pdf: {
        parameters: {
            query?: {
                as_sent?: boolean;
            };
            header?: never;
            path: {
                contract_id: string;
                version: number;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/pdf": string;
                };
            };
            /** @description `contract-not-found`, `contract-version-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    download_contract_docx: {
        parameters: {
            query?: {
                against?: number | null;
            };
            header?: never;
            path: {
                contract_id: string;
                version: number;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/vnd.openxmlformats-officedocument.wordprocessingml.document": string;
                };
            };
            /** @description `contract-not-found`, `contract-version-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `too-long-to-compare` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `too-many-at-once` */
            429: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    compare_contract_versions: {
        parameters: {
            query: {
                from_version: number;
                to_version: number;
            };
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ComparisonRead"];
                };
            };
            /** @description `contract-not-found`, `contract-version-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `too-long-to-compare` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `too-many-at-once` */
            429: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    read_contract_record: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["RecordRead"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    download_contract_record: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": unknown;
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    download_contract_head: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": unknown;
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    read_redlines: {
        parameters: {
            query?: {
                round?: number | null;
            };
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["RedlinesRead"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
            /** @description `too-many-at-once` */
            429: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    propose_redlines: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["RedlinesAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["RedlinesRead"];
                };
            };
            /** @description `not-your-contract` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `wrong-state`, `text-changed` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-redlines` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `too-many-at-once` */
            429: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    preview_redlines: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["RedlinesSet"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["RedlinesPreview"];
                };
            };
            /** @description `not-your-contract` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `wrong-state` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
            /** @description `too-many-at-once` */
            429: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    answer_redline: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
                redline_number: number;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["RedlineAnswerAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["RedlinesRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found`, `redline-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `wrong-state` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-redlines` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `too-many-at-once` */
            429: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    verify_pdf: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/pdf": string;
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["VerifiedRead"];
                };
            };
            /** @description `bad-pdf` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `too-many-attempts` */
            429: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `parsing-busy` */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    read_ending: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["EndingRead"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    give_notice: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["NoticeAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["EndingRead"];
                };
            };
            /** @description `not-your-contract` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `already-ended`, `notice-given` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `notice-too-short` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    withdraw_notice: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["EndingRead"];
                };
            };
            /** @description `not-your-contract` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `already-ended`, `no-notice` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    agree_to_statement: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["AcceptAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["EndingRead"];
                };
            };
            /** @description `not-your-contract`, `address-not-proven`, `same-person-on-both-sides`, `signing-code-needed`, `wrong-signing-code` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `already-ended`, `no-notice`, `already-accepted`, `signing-code-over`, `text-changed` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    download_statement: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The text as PDF */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/pdf": unknown;
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `no-notice` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `document-too-large` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `typesetting-busy` */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    list_change_orders: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ChangeOrdersRead"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    propose_change_order: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["ChangeOrderAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ChangeOrdersRead"];
                };
            };
            /** @description `not-your-contract` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `not-in-force` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-change-order` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    preview_change_order: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["ChangesSet"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ChangePreview"];
                };
            };
            /** @description `not-your-contract` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `not-in-force` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    dismiss_change_offer: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["OfferDismiss"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ChangeOrdersRead"];
                };
            };
            /** @description `not-your-contract` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found`, `change-offer-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `not-in-force` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    accept_change_order: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
                change_order_number: number;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["AcceptAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ChangeOrdersRead"];
                };
            };
            /** @description `not-your-contract`, `address-not-proven`, `same-person-on-both-sides`, `signing-code-needed`, `wrong-signing-code` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found`, `change-order-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `change-order-closed`, `not-in-force`, `change-order-stale`, `already-accepted`, `signing-code-over`, `text-changed` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    refuse_change_order: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
                change_order_number: number;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["ReasonGiven"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ChangeOrdersRead"];
                };
            };
            /** @description `not-your-contract` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found`, `change-order-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `change-order-closed`, `own-change-order` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    withdraw_change_order: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
                change_order_number: number;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["ReasonGiven"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ChangeOrdersRead"];
                };
            };
            /** @description `not-your-contract` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found`, `change-order-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `change-order-closed`, `not-own-change-order` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    download_change_order: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
                change_order_number: number;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The text as PDF */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/pdf": unknown;
                };
            };
            /** @description `contract-not-found`, `change-order-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `document-too-large` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `typesetting-busy` */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    put_upload: {
        parameters: {
            query: {
                delivery_id: string;
                file_name: string;
                /** @description Of the take that a dry stem is for. */
                take_id?: string | null;
            };
            header?: {
                /** @description RFC 9530, `sha-256=:…:` */
                "repr-digest"?: string | null;
                /** @description The file's SHA-256 in hex. */
                "x-content-sha256"?: string | null;
            };
            path?: never;
            cookie?: never;
        };
        requestBody?: {
            content: {
                "application/octet-stream": string;
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["UploadRead"];
                };
            };
            /** @description `bad-upload-header`, `upload-incomplete` */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `designer-needed`, `in-house-designer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `delivery-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `upload-stalled` */
            408: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `delivery-closed` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `length-required` */
            411: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `upload-too-long` */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
            /** @description `checksum-mismatch` */
            460: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `store-full` */
            507: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    begin_upload: {
        parameters: {
            query?: never;
            header?: {
                /** @description 1.0.0 */
                "Tus-Resumable"?: string | null;
                /** @description How many bytes the whole file has. */
                "upload-length"?: string | null;
                /** @description In Base64: `delivery_id`, `file_name`, `sha256` if known, `take_id` of what a dry stem is for. */
                "upload-metadata"?: string | null;
                "upload-checksum"?: string | null;
            };
            path?: never;
            cookie?: never;
        };
        requestBody?: {
            content: {
                "application/offset+octet-stream": string;
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description `bad-upload-header` */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `designer-needed`, `in-house-designer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `delivery-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `upload-stalled` */
            408: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `delivery-closed` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `unknown-tus-version` */
            412: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `upload-too-long` */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `wrong-content-type` */
            415: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
            /** @description `checksum-mismatch` */
            460: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `store-full` */
            507: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    describe_uploads: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
        };
    };
    cancel_upload: {
        parameters: {
            query?: never;
            header?: {
                /** @description 1.0.0 */
                "Tus-Resumable"?: string | null;
            };
            path: {
                upload_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description `upload-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `unknown-tus-version` */
            412: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
            /** @description `upload-busy` */
            423: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    see_upload: {
        parameters: {
            query?: never;
            header?: {
                /** @description 1.0.0 */
                "Tus-Resumable"?: string | null;
            };
            path: {
                upload_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description `upload-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `unknown-tus-version` */
            412: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
            /** @description `upload-busy` */
            423: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    continue_upload: {
        parameters: {
            query?: never;
            header?: {
                /** @description 1.0.0 */
                "Tus-Resumable"?: string | null;
                /** @description How many bytes are here already. */
                "upload-offset"?: string | null;
                /** @description `sha256` or `sha1`, a space, the digest in Base64. */
                "upload-checksum"?: string | null;
            };
            path: {
                upload_id: string;
            };
            cookie?: never;
        };
        requestBody?: {
            content: {
                "application/offset+octet-stream": string;
            };
        };
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description `bad-upload-header` */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `upload-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `upload-stalled` */
            408: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `offset-mismatch`, `sent-in-parts` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `unknown-tus-version` */
            412: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `upload-too-long` */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `wrong-content-type` */
            415: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
            /** @description `upload-busy` */
            423: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `checksum-mismatch` */
            460: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `store-unavailable` */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `store-full` */
            507: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    request_parts: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                upload_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["PartsAsk"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PartsRead"];
                };
            };
            /** @description `upload-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `parts-not-taken` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `part-unknown` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `store-unavailable` */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    finish_parts: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                upload_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["UploadRead"];
                };
            };
            /** @description `upload-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `upload-unfinished` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
            /** @description `upload-busy` */
            423: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `checksum-mismatch` */
            460: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `store-unavailable` */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    accept_sure_matches: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["SureAccept"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TrayActionRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    move_takes: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["TakesMove"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TrayActionRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found`, `take-not-found`, `cue-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `wrong-state` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `variation-unknown` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    preview_renames: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["TakesMove"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TakeRename"][];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found`, `take-not-found`, `cue-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `variation-unknown` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    discard_takes: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["TakesNamed"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TrayActionRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found`, `take-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `wrong-state` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    restore_takes: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["TakesNamed"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TrayActionRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found`, `take-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    undo_tray_action: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                tray_action_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TrayActionUndone"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `tray-action-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `already-undone` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    add_file: {
        parameters: {
            query: {
                /** @description Never used as a path. */
                file_name: string;
                /** @description Without it the name says which cue it is for. */
                cue_id?: string | null;
                variation?: number | null;
            };
            header?: {
                /** @description The file's SHA-256 in hex. */
                "x-content-sha256"?: string | null;
            };
            path: {
                delivery_id: string;
            };
            cookie?: never;
        };
        requestBody?: {
            content: {
                "application/octet-stream": string;
            };
        };
        responses: {
            /** @description The same file was here before; this is its take. */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TakeAdded"];
                };
            };
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TakeAdded"];
                };
            };
            /** @description It is named `…__dry`: the dry stem of the take so named. */
            202: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["DryStemRead"];
                };
            };
            /** @description `bad-upload-header`, `upload-incomplete` */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `designer-needed`, `in-house-designer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `cue-not-found`, `delivery-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `delivery-closed` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `length-required` */
            411: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `variation-unknown` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `checksum-mismatch` */
            460: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `store-full` */
            507: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    see_delivery_sources: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                delivery_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["DeliverySources"];
                };
            };
            /** @description `delivery-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    state_delivery_sources: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                delivery_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Sources"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["DeliverySources"];
                };
            };
            /** @description `designer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `delivery-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `no-source-named` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    see_take_sources: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                take_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TakeSources"];
                };
            };
            /** @description `take-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    state_take_sources: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                take_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Sources"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TakeSources"];
                };
            };
            /** @description `own-designer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `take-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `sources-fixed` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `no-source-named` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    list_deliveries: {
        parameters: {
            query?: {
                /** @description `next` of the page before. */
                cursor?: string | null;
                limit?: number;
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Page_DeliveryRead_"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    open_delivery: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["DeliveryAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["DeliveryRead"];
                };
            };
            /** @description `designer-needed`, `in-house-designer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    see_delivery: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                delivery_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["DeliveryDetail"];
                };
            };
            /** @description `delivery-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    change_delivery: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                delivery_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["DeliveryChange"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["DeliveryRead"];
                };
            };
            /** @description `designer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `delivery-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    close_delivery: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                delivery_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["DeliveryRead"];
                };
            };
            /** @description `designer-needed`, `in-house-designer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `delivery-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    add_take: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                delivery_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["TakeAdd"];
            };
        };
        responses: {
            /** @description The same file was here before; this is its take. */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TakeAdded"];
                };
            };
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TakeAdded"];
                };
            };
            /** @description It is named `…__dry`: no take, but the dry stem of the take so named. */
            202: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["DryStemRead"];
                };
            };
            /** @description `designer-needed`, `in-house-designer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `delivery-not-found`, `upload-not-found`, `cue-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `upload-unfinished` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `variation-unknown` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    add_archive: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                delivery_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["ArchiveAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ArchiveRead"];
                };
            };
            /** @description `designer-needed`, `in-house-designer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `delivery-not-found`, `upload-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `upload-unfinished` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    list_takes: {
        parameters: {
            query?: {
                /** @description One or several. */
                state?: components["schemas"]["TakeState"][];
                unmatched?: boolean | null;
                /** @description Those taken out of list and tray, in place of the others. */
                discarded?: boolean;
                cue_id?: string | null;
                /** @description `next` of the page before. */
                cursor?: string | null;
                limit?: number;
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Page_TakeRead_"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    see_take: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                take_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TakeRead"];
                };
            };
            /** @description `take-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    match_take: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                take_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["TakeMatch"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TakeRead"];
                };
            };
            /** @description `take-not-found`, `cue-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `wrong-state` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `variation-unknown` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    download_master: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                take_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/octet-stream": unknown;
                };
            };
            /** @description `download-unpaid` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `take-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
            /** @description `blob-missing` */
            500: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    download_dry_stem: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                take_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/octet-stream": unknown;
                };
            };
            /** @description `download-unpaid` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `take-not-found`, `dry-stem-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
            /** @description `blob-missing` */
            500: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    add_dry_stem_to_take: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                take_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["DryStemUpload"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["DryStemRead"];
                };
            };
            /** @description `own-designer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `take-not-found`, `upload-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `wrong-state`, `upload-unfinished` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    withdraw_dry_stem: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                take_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description `own-designer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `take-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `wrong-state` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    list_checks: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["CheckDescription"][];
                };
            };
        };
    };
    see_check: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                take_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["CheckRead"];
                };
            };
            /** @description `take-not-found`, `check-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    waive_findings: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                take_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["WaiverAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["CheckRead"];
                };
            };
            /** @description `approver-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `take-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `nothing-to-waive` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    recheck_take: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                take_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            202: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TakeRead"];
                };
            };
            /** @description `take-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `wrong-state` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    list_fixes: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["FixOffer"][];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    see_fix: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                take_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["FixRead"];
                };
            };
            /** @description `take-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    request_fix: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                take_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            202: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["FixRead"];
                };
            };
            /** @description `own-designer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `take-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `nothing-to-fix` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    use_fix: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                take_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The fix was used before; this is its take. */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TakeRead"];
                };
            };
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TakeRead"];
                };
            };
            /** @description `own-designer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `take-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `nothing-to-fix`, `fix-not-ready` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    get_take_sounds: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                take_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TakeSoundsRead"];
                };
            };
            /** @description `take-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    get_preview: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                picture_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "audio/flac": unknown;
                    "audio/wav": unknown;
                };
            };
            /** @description `sound-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `not-drawn` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
            /** @description `blob-missing` */
            500: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_peaks: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                picture_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PeaksRead"];
                };
            };
            /** @description `sound-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `not-drawn` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
            /** @description `blob-missing` */
            500: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_spectrum: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                picture_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "image/png": unknown;
                };
            };
            /** @description `sound-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `not-drawn` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
            /** @description `blob-missing` */
            500: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_render_file: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                render_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "audio/wav": unknown;
                };
            };
            /** @description `download-unpaid` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `render-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `nothing-rendered` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
            /** @description `blob-missing` */
            500: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_render_loss: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                render_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["LossRead"];
                };
            };
            /** @description `render-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `loss-unknown` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    list_batches: {
        parameters: {
            query?: {
                cursor?: string | null;
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Page_BatchSummary_"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    add_batch: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["BatchAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["BatchSummary"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `nothing-to-render` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `target-unknown` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_batch: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                batch_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["BatchRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `batch-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    cancel_batch: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                batch_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["BatchRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `batch-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `batch-ended` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    add_reel: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                cue_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["ReelAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ReelRead"];
                };
            };
            /** @description `cue-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `nothing-to-play`, `takes-being-drawn`, `reel-too-long` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    get_reel: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                reel_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ReelRead"];
                };
            };
            /** @description `reel-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    get_reel_file: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                reel_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "audio/wav": unknown;
                };
            };
            /** @description `reel-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `reel-not-made` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
            /** @description `blob-missing` */
            500: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    add_master_export: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                take_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["MasterExportRead"];
                };
            };
            /** @description `download-unpaid` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `take-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    get_master_export: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                master_export_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["MasterExportRead"];
                };
            };
            /** @description `master-export-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    get_master_export_file: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                master_export_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "audio/wav": unknown;
                };
            };
            /** @description `download-unpaid` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `master-export-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `master-export-not-made` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
            /** @description `blob-missing` */
            500: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_review_queue: {
        parameters: {
            query?: {
                project_id?: string | null;
                /** @description The cues that the caller approves today. Who approves none in a project is shown all of it. */
                own?: boolean;
                cursor?: string | null;
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Page_QueueItem_"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-cursor` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    count_review_queue: {
        parameters: {
            query?: {
                project_id?: string | null;
                /** @description The cues that the caller approves today. Who approves none in a project is shown all of it. */
                own?: boolean;
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["QueueCount"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    get_cue_review: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                cue_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["CueReviewRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `cue-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    give_verdict: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                take_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["VerdictGive"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["VerdictGiven"];
                };
            };
            /** @description `approver-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `take-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `stale-view`, `not-reviewable`, `wrong-state`, `cue-is-cut` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `note-needed`, `range-invalid` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    undo_verdict: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                take_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["VerdictUndone"];
                };
            };
            /** @description `approver-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `take-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `nothing-to-undo`, `too-late-to-undo`, `verdict-since`, `cue-is-cut` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    accept_set: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                cue_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["SetAccept"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SetAccepted"];
                };
            };
            /** @description `approver-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `cue-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `set-incomplete`, `already-accepted`, `not-reviewable`, `cue-is-cut` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `not-of-this-cue` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    list_change_requests: {
        parameters: {
            query?: {
                state?: "draft" | "sent";
                cursor?: string | null;
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Page_ChangeRequestRead_"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-cursor` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    drop_change_request: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                change_request_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description `approver-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `change-request-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `already-sent` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    send_change_requests: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["FeedbackAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["FeedbackRead"];
                };
            };
            /** @description `approver-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `nothing-to-send` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    list_comments: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                take_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["CommentRead"][];
                };
            };
            /** @description `take-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    add_comment: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                take_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["CommentAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["CommentRead"];
                };
            };
            /** @description `take-not-found`, `comment-not-found`, `change-request-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `range-invalid` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    resolve_comment: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                comment_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["CommentRead"];
                };
            };
            /** @description `comment-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    answer_carried_note: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                take_id: string;
                note_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["NoteAnswerGive"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["CarriedNote"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `take-not-found`, `note-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    get_take_history: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                take_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HistoryEntry"][];
                };
            };
            /** @description `take-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    cut_cue: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                cue_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["CueCut"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["CueCutRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `cue-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `cue-is-cut` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    see_take_fit: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                take_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TakeFitRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `take-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    see_delivery_fit: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                delivery_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["DeliveryFitRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `delivery-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    get_pack: {
        parameters: {
            query?: {
                /** @description A target of the spec; its first when left out. */
                target?: string | null;
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PackRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `target-unknown` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    download_pack: {
        parameters: {
            query?: {
                /** @description A target of the spec; its first when left out. */
                target?: string | null;
                masters?: boolean;
                /** @description Leave out accepted sounds that have no game file; the key says why. */
                allow_missing?: boolean;
                /** @description Put marked placeholder files in for the sounds that are not accepted. */
                placeholders?: boolean;
                /** @description The engine whose import files go with the sounds. */
                handoff?: components["schemas"]["Handoff"];
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/zip": string;
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `nothing-accepted`, `pack-incomplete`, `placeholder-accepted` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `target-unknown`, `document-too-large` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `blob-damaged` */
            500: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `typesetting-busy` */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_documentation_key_csv: {
        parameters: {
            query?: {
                /** @description A target of the spec; its first when left out. */
                target?: string | null;
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/csv": unknown;
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `target-unknown` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_documentation_key_xlsx: {
        parameters: {
            query?: {
                /** @description A target of the spec; its first when left out. */
                target?: string | null;
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet": string;
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `target-unknown` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_documentation_key_pdf: {
        parameters: {
            query?: {
                /** @description A target of the spec; its first when left out. */
                target?: string | null;
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/pdf": string;
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `target-unknown`, `document-too-large` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `too-many-at-once` */
            429: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `typesetting-busy` */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_targets: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TargetsRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    get_placeholders: {
        parameters: {
            query?: {
                /** @description A target of the spec; its first when left out. */
                target?: string | null;
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PlaceholderRegister"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `target-unknown` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    make_placeholders: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["PlaceholdersAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            202: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `target-unknown` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_placeholders_countdown: {
        parameters: {
            query?: {
                /** @description A target of the spec; its first when left out. */
                target?: string | null;
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PlaceholderCountdown"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `target-unknown` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    list_packs: {
        parameters: {
            query?: {
                /** @description Of one target only. */
                target?: string | null;
                cursor?: string | null;
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Page_SealedPackSummary_"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    add_pack: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["PackAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SealedPackSummary"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `nothing-accepted`, `pack-incomplete`, `placeholder-accepted` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `target-unknown` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_sealed_pack: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                pack_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SealedPackRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `pack-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    download_sealed_pack: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                pack_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/zip": string;
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `pack-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `pack-not-sealed` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
            /** @description `blob-damaged` */
            500: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    list_builds: {
        parameters: {
            query?: {
                cursor?: string | null;
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Page_BuildSummary_"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    post_build: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["BuildAdd"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["BuildSummary"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `report-invalid` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_build: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                build_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["BuildRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `build-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    get_baseline: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Baseline"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    get_ci_lines: {
        parameters: {
            query?: {
                /** @description A target of the spec; its first when left out. */
                target?: string | null;
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["CiLines"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `target-unknown` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_clearance_sheet_xlsx: {
        parameters: {
            query?: {
                /** @description A target of the spec; its first when left out. */
                target?: string | null;
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet": string;
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `target-unknown` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_clearance_sheet_pdf: {
        parameters: {
            query?: {
                /** @description A target of the spec; its first when left out. */
                target?: string | null;
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/pdf": string;
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `target-unknown`, `document-too-large` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `too-many-at-once` */
            429: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `typesetting-busy` */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_pack_clearance_sheet_xlsx: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                pack_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet": string;
                };
            };
            /** @description `team-needed`, `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `pack-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `pack-not-sealed` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    get_pack_clearance_sheet_pdf: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                pack_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/pdf": string;
                };
            };
            /** @description `team-needed`, `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `pack-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `pack-not-sealed` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `document-too-large` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `too-many-at-once` */
            429: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `typesetting-busy` */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    download_handover: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                contract_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/zip": string;
                };
            };
            /** @description `producer-needed`, `same-person-on-both-sides` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `contract-not-ended` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
            /** @description `blob-damaged` */
            500: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_manifest: {
        parameters: {
            query?: {
                /** @description A target of the spec; its first when left out. */
                target?: string | null;
                /** @description Leave out accepted sounds that have no game file, as the pack does. */
                allow_missing?: boolean;
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Manifest"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `pack-incomplete`, `manifest-not-ready` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `target-unknown` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `blob-damaged` */
            500: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_sealed_manifest: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                pack_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Manifest"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `pack-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `pack-not-sealed`, `manifest-not-ready` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
            /** @description `blob-damaged` */
            500: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    list_game_files: {
        parameters: {
            query?: {
                /** @description A target of the spec; its first when left out. */
                target?: string | null;
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["GameFilesRead"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `target-unknown` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    list_game_file_origins: {
        parameters: {
            query?: {
                /** @description A path in the game, a file name, its stem, or a cue's number. */
                name?: string;
                /** @description A target of the spec; its first when left out. */
                target?: string | null;
                /** @description Only this version, which may have been replaced since. */
                take?: string | null;
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["GameFileOrigin"][];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `target-unknown` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    get_client_program: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/zip": string;
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    get_game_file: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
                render_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "audio/wav": unknown;
                };
            };
            /** @description `team-needed`, `download-unpaid` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found`, `render-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `game-file-not-approved`, `nothing-rendered` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
            /** @description `blob-missing` */
            500: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    read_list_progress: {
        parameters: {
            query?: {
                cursor?: string | null;
                /** @description How many cues to answer at most. */
                limit?: number;
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ListProgress"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-cursor` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    read_list_counts: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ListCounts"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    read_recent_verdicts: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["RecentVerdict"][];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    read_today: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Today"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    read_next_steps: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["NextSteps"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    read_pace: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Pace"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    read_desk: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Desk"];
                };
            };
            /** @description `designer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    list_came_back: {
        parameters: {
            query?: {
                cursor?: string | null;
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Page_CameBack_"];
                };
            };
            /** @description `designer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-cursor` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    list_to_make: {
        parameters: {
            query?: {
                cursor?: string | null;
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Page_ToMake_"];
                };
            };
            /** @description `designer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-cursor` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    list_with_approver: {
        parameters: {
            query?: {
                cursor?: string | null;
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Page_WithApprover_"];
                };
            };
            /** @description `designer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-cursor` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    read_overview: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Overview"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    read_project_money: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ProjectMoney"];
                };
            };
            /** @description `team-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    read_milestone: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                milestone_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["MilestoneSheet"];
                };
            };
            /** @description `milestone-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    find: {
        parameters: {
            query: {
                q: string;
            };
            header?: never;
            path: {
                project_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["FindResult"];
                };
            };
            /** @description `project-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    watch_changes: {
        parameters: {
            query?: {
                /** @description How long to go on. */
                seconds?: number;
            };
            header?: {
                "last-event-id"?: string | null;
            };
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description `open` says whether all since Last-Event-ID follows; `change` has `project_id` (null: the studio itself), `studio_id` and `rooms`; `beat` comes every 15 s. */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/event-stream": string;
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
            /** @description `too-many-streams` */
            429: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    read_outbox: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                studio_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["OutboxRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `studio-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    send_mail_again: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                mail_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["MailRead"];
                };
            };
            /** @description `mail-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    read_studio_operations: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                studio_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["StudioOperations"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `studio-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    read_studio_storage: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                studio_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["StorageRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `studio-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    list_studio_jobs: {
        parameters: {
            query?: {
                state?: components["schemas"]["JobState"] | null;
                cursor?: string | null;
            };
            header?: never;
            path: {
                studio_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Page_JobRead_"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `studio-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-cursor` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    retry_studio_job: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                studio_id: string;
                job_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["JobRead"];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `studio-not-found`, `job-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `job-not-parked` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    read_operations: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ServerOperations"];
                };
            };
            /** @description `operator-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    read_studio_quotas: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                studio_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["QuotaRead"][];
                };
            };
            /** @description `producer-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `studio-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
    read_quotas: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["StudioQuotas"][];
                };
            };
            /** @description `operator-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    read_storage: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ServerStorage"];
                };
            };
            /** @description `operator-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    list_jobs: {
        parameters: {
            query?: {
                state?: components["schemas"]["JobState"] | null;
                cursor?: string | null;
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Page_JobRead_"];
                };
            };
            /** @description `operator-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `bad-cursor` */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
        };
    };
    retry_job: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                job_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["JobRead"];
                };
            };
            /** @description `operator-needed` */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `job-not-found` */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description `job-not-parked` */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Problem"];
                };
            };
            /** @description Validation Error */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HTTPValidationError"];
                };
            };
        };
    };
}
